#include "compare.hpp"

#include <cmath>

#include "pantin/geometry.hpp"

namespace pantin::compare {
namespace {

// CRC-32 as in zlib and PNG (polynomial 0xEDB88320), bit by bit.
std::uint32_t crc32(const std::uint8_t* bytes, std::size_t count) {
    std::uint32_t crc = 0xFFFFFFFFu;
    for (std::size_t i = 0; i < count; ++i) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) ? 0xEDB88320u : 0u);
    }
    return ~crc;
}

void exact(Report& report, const std::string& stage, double ours, double stored, const std::string& where) {
    report.add(stage, ours == stored, ours - stored, where);
}

void mask_stage(const Figure& figure, Report& report) {
    long area = 0;
    for (const auto pixel : figure.mask) area += pixel;
    exact(report, "mask area", static_cast<double>(area), figure.stored.at("mask_area"), figure.name);
    report.add("mask CRC", crc32(figure.mask.data(), figure.mask.size()) == figure.stored.at("mask_crc32_u8"),
               0, figure.name);
    report.add("nearest labels CRC",
               crc32(figure.near.data(), figure.near.size()) == figure.stored.at("near_crc32_u8"), 0,
               figure.name);
}

void contour_stage(const Figure& figure, Report& report) {
    const std::vector<Border> borders = follow_borders(figure.mask);
    const std::vector<Point2i>& contour = borders.at(0).points;
    const auto same = [](Point2i p, const nlohmann::json& xy) { return p.x == xy[0] && p.y == xy[1]; };
    exact(report, "contour pixels", static_cast<double>(contour.size()), figure.stored.at("contour_pixels"),
          figure.name);
    report.add("contour first and second point",
               same(contour.at(0), figure.stored.at("contour_first")) &&
                   same(contour.at(1), figure.stored.at("contour_second")),
               0, figure.name);
    std::vector<std::uint8_t> bytes;
    for (const Point2i p : contour)
        for (const int v : {p.x, p.y})
            for (int shift = 0; shift < 32; shift += 8)
                bytes.push_back(static_cast<std::uint8_t>(static_cast<std::uint32_t>(v) >> shift));
    report.add("contour CRC", crc32(bytes.data(), bytes.size()) == figure.stored.at("contour_crc32_i32_xy"),
               0, figure.name);
    const double difference = closed_length(contour) - figure.stored.at("contour_length").get<double>();
    report.add("contour length", std::abs(difference) < 1e-9, difference, figure.name);
}

} // namespace

void skeleton_stages(const std::vector<Figure>& figures, Report& report) {
    for (const Figure& figure : figures) {
        mask_stage(figure, report);
        contour_stage(figure, report);
    }
}

} // namespace pantin::compare
