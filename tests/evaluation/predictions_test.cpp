// SPDX-License-Identifier: MIT
// `pantin evaluate --predictions`: another program's answers are judged as ours are.
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "core/file.hpp"
#include "evaluation/dataset.hpp"
#include "pantin/error.hpp"
#include "pantin/evaluation.hpp"
#include "support/folders.hpp"
#include "support/program.hpp"
#include "support/schemas.hpp"

namespace pantin::test {
namespace {

namespace fs = std::filesystem;

// Two pages with two characters each, and the truth again as predictions.
class Answers {
public:
    Answers() {
        write_dataset(data());
        for (const char* part : {"label", "instance"})
            fs::copy(data() / part, predictions() / part, fs::copy_options::recursive);
        fs::copy_file(data() / "index.ndjson", predictions() / "index.ndjson");
    }
    fs::path data() const { return folder_ / "data"; }
    fs::path predictions() const {
        fs::create_directories(folder_ / "predictions");
        return folder_ / "predictions";
    }
    Evaluation judged() const { return evaluate_predictions(Dataset(data()), predictions()); }
    nlohmann::json json() const { return nlohmann::json::parse(evaluation_to_json(judged())); }
    Grid<std::uint8_t> picture(const std::string& name) const {
        const RgbImage image = load_image(predictions() / name);
        Grid<std::uint8_t> values(image.width(), image.height());
        for (std::size_t i = 0; i < values.size(); ++i) values.data()[i] = image.data()[i].r;
        return values;
    }

private:
    TemporaryFolder folder_;
};

} // namespace

TEST_CASE("The truth as predictions is perfect, and what it does not hold is not measured") {
    const Answers answers;
    const nlohmann::json json = answers.json();
    CHECK(schema_violation("evaluation", json) == "");
    CHECK((json["pages"] == 2 && json["characters"] == 4 && json["unanswered_pages"] == 0));
    for (const char* key : {"mask_ap50", "mask_ap75", "silhouette_ap50", "silhouette_ap75"})
        CHECK(json["detection"][key] == 1);
    CHECK((json["detection"]["missed"] == 0 && json["detection"]["false"] == 0));
    CHECK((json["segmentation"]["all"]["mean IoU"] == 1 && json["segmentation"]["all"]["pixels"] == 1));
    CHECK(json["segmentation"]["all"]["router"].is_null());
    CHECK(json["segmentation"]["all"]["pose"] == 1);
    CHECK(json["identification"] ==
          nlohmann::json{{"humanoid", {{"humanoid", 2}}}, {"quadruped", {{"quadruped", 2}}}});
    CHECK((json["stages"]["detected"] == 4 && json["stages"]["segmented"] == 4 &&
           json["stages"]["identified"] == 4));
    for (const char* stage : {"skeleton", "rigged"}) CHECK(json["stages"][stage].is_null());
    CHECK(json["warnings"]["lost_ink"].is_null());
    for (const nlohmann::json& row : json["measurements"])
        if (row["table"] == "seconds") CHECK(row["count"] == 0);
}

TEST_CASE("Damage to predictions shows where it is: a mask, a part, a type, a page that is missing") {
    const Answers answers;
    const fs::path folder = answers.predictions();
    // One character of four is gone, another has half of its pixels relabelled as wing.
    Grid<std::uint8_t> numbers = answers.picture("instance/page-1.png"),
                       labels = answers.picture("label/page-1.png");
    long all = 0, changed = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers.data()[i] == 2) numbers.data()[i] = labels.data()[i] = 0;
        all += labels.data()[i] != 0;
        if (labels.data()[i] == 3) labels.data()[i] = 5, ++changed; // limbs
    }
    REQUIRE(changed > 0);
    save_png(folder / "instance/page-1.png", numbers);
    save_png(folder / "label/page-1.png", labels);
    const Evaluation evaluation = answers.judged();
    CHECK(average_precision(evaluation, 0.5, true) == 0.75); // three of four, all in front
    CHECK_FALSE(evaluation.characters[1].found);
    CHECK(evaluation.characters[0].part_overlap[3] == 0);
    CHECK(evaluation.characters[0].part_overlap[1] == 1);
    CHECK(evaluation.characters[0].pixel_accuracy == Approx(1 - static_cast<double>(changed) / all));
    CHECK(evaluation.characters[0].mask_overlap == 1);
    CHECK(evaluation.characters[2].mean_overlap() == 1);

    fs::remove(folder / "label/page-2.png");
    fs::remove(folder / "instance/page-2.png");
    const nlohmann::json json = answers.json();
    CHECK(json["unanswered_pages"] == 1);
    CHECK(json["detection"]["missed"] == 3);
    CHECK(json["detection"]["mask_ap50"] == 0.25);
}

TEST_CASE("The scores of predictions rank them") {
    const Answers answers;
    // On page 1 the first answer's place is exchanged for nothing that is there: a false one.
    Grid<std::uint8_t> numbers = answers.picture("instance/page-1.png");
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (numbers.data()[i] == 1) numbers.data()[i] = 0;
    for (int x = 0; x < 20; ++x) numbers(x, 0) = 1;
    fs::remove_all(answers.predictions() / "label");
    save_png(answers.predictions() / "instance/page-1.png", numbers);
    const auto ap50 = [&](double of_false) {
        const auto character = [](double score) { return nlohmann::json{{"score", score}}; };
        const nlohmann::json one = {{"id", "page-1"}, {"characters", {character(of_false), character(0.5)}}},
                             two = {{"id", "page-2"}, {"characters", {character(0.5), character(0.5)}}};
        write_file(answers.predictions() / "index.ndjson",
                   std::string_view(one.dump() + "\n" + two.dump() + "\n"));
        return average_precision(answers.judged(), 0.5, true);
    };
    CHECK(ap50(0.1) == 0.75);                // behind three hits
    CHECK(ap50(0.9) == Approx(0.75 * 0.75)); // before them: precisions 1/2, 2/3, 3/4, made monotone
    const nlohmann::json json = answers.json();
    CHECK(json["segmentation"]["all"]["mean IoU"].is_null()); // there are no labels
    CHECK(json["stages"]["segmented"].is_null());
    CHECK(json["stages"]["identified"].is_null()); // nor types
    CHECK(json["identification"].empty());
}

TEST_CASE("Types alone are judged in the order of the index") {
    const Answers answers;
    for (const char* part : {"label", "instance"}) fs::remove_all(answers.predictions() / part);
    write_file(
        answers.predictions() / "index.ndjson",
        std::string_view(
            "{\"id\": \"page-2\", \"characters\": [{\"type\": \"humanoid\"}, {\"type\": \"flying\"}]}\n"));
    const nlohmann::json json = answers.json();
    CHECK(json["identification"]["humanoid"] == nlohmann::json{{"humanoid", 1}, {"none", 1}});
    CHECK(json["identification"]["quadruped"] == nlohmann::json{{"flying", 1}, {"none", 1}});
    CHECK(json["unanswered_pages"] == 1);
    CHECK(json["detection"]["mask_ap50"].is_null());
    CHECK(json["stages"]["detected"].is_null());
    CHECK(json["stages"]["identified"] == 1);
}

TEST_CASE("Our own results as predictions get our own values", "[cli][end-to-end]") {
    const Answers answers;
    const fs::path out = answers.data().parent_path() / "out";
    REQUIRE(run_pantin({"evaluate", answers.data().string(), "-o", out.string()}).code == 0);
    const nlohmann::json ours = nlohmann::json::parse(read_text(out / "evaluation.json"));
    // The labels of each character, put back onto its page as anybody would.
    std::string index;
    for (const char* id : {"page-1", "page-2"}) {
        const nlohmann::json page = nlohmann::json::parse(read_text(out / "pages" / id / "page.json"));
        LabelMap labels(page["width"], page["height"], 0);
        GreyImage numbers(labels.width(), labels.height(), 0);
        nlohmann::json row = {{"id", id}, {"characters", nlohmann::json::array()}};
        int number = 0;
        for (const nlohmann::json& c : page["characters"]) {
            const fs::path folder = out / "pages" / id / c["folder"].get<std::string>();
            const RgbImage parts = load_image(folder / "labels.png");
            const int left = c["box"][0], top = c["box"][1], width = c["box"][2], height = c["box"][3];
            ++number;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    if (const auto part = parts(x * parts.width() / width, y * parts.height() / height).r)
                        labels(left + x, top + y) = part,
                                               numbers(left + x, top + y) = static_cast<std::uint8_t>(number);
            row["characters"].push_back({{"score", c["score"]}, {"type", c.value("type", "")}});
        }
        index += row.dump() + "\n";
        save_png(answers.predictions() / "label" / (std::string(id) + ".png"), labels);
        save_png(answers.predictions() / "instance" / (std::string(id) + ".png"), numbers);
    }
    write_file(answers.predictions() / "index.ndjson", std::string_view(index));
    const Outcome outcome = run_pantin({"evaluate", answers.data().string(), "--predictions",
                                        answers.predictions().string(), "-o", (out / "again").string()});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    const nlohmann::json again = nlohmann::json::parse(read_text(out / "again/evaluation.json"));
    for (const char* key : {"silhouette_ap50", "silhouette_ap75"})
        CHECK(again["detection"][key] == ours["detection"][key]);
    for (const char* key : {"mean IoU", "head", "body", "limb", "tail", "pixels", "silhouette"})
        CHECK(again["segmentation"]["all"][key] == ours["segmentation"]["all"][key]);
    CHECK(again["identification"] == ours["identification"]);
    CHECK_FALSE(fs::exists(out / "again/pages"));
}

TEST_CASE("Predictions that do not fit are refused with the fact") {
    const Answers answers;
    const auto failure = [&] {
        try {
            answers.judged();
        } catch (const Error& error) {
            CHECK(error.kind() == ErrorKind::input);
            return std::string(error.what());
        }
        return std::string();
    };
    const std::string folder = answers.predictions().string();
    save_png(answers.predictions() / "label/page-1.png", LabelMap(32, 32, 1));
    CHECK(failure() == folder + "/instance/page-1.png: has another size than the label map");
    fs::remove(answers.predictions() / "instance/page-1.png");
    CHECK(failure() == folder + ": the prediction for page-1 has another size than its label map");
    const std::string index = read_text(answers.predictions() / "index.ndjson");
    write_file(answers.predictions() / "index.ndjson", std::string_view(index + index));
    CHECK(failure() == folder + "/index.ndjson: lists 'page-1' twice");
    fs::remove_all(answers.predictions());
    CHECK(failure() == folder + ": has neither label/, instance/ nor types in an index.ndjson");
}

} // namespace pantin::test
