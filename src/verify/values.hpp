// SPDX-License-Identifier: MIT
// Files as values, so that two of them can be compared whatever their encoding.
#pragma once

#include <string>
#include <vector>

#include "pantin/verify.hpp"

namespace pantin {

// Collects what differs while two files are walked side by side: the first place, the number, the largest
// difference.
class Differences {
public:
    explicit Differences(std::string file) { found_.file = std::move(file); }

    void number(const std::string& place, double first, double second); // equal when all bits are
    void text(const std::string& place, const std::string& first, const std::string& second);
    void picture(RgbImage image) {
        if (!found_.picture) found_.picture = std::move(image);
    }
    std::optional<FileDifference> result() const {
        return found_.values > 0 ? std::optional(found_) : std::nullopt;
    }
    std::size_t count() const { return found_.values; }

private:
    FileDifference found_;

    void add(const std::string& place, const std::string& first, const std::string& second);
};

// By kind of file. Error(input) when one is damaged.
void compare_json(Differences& differences, const std::string& name, const std::string& first,
                  const std::string& second);
void compare_glb(Differences& differences, const std::string& name, const std::string& first,
                 const std::string& second);
void compare_words(Differences& differences, const std::string& first, const std::string& second);
void compare_bytes(Differences& differences, const std::string& first, const std::string& second);
// `place`: of the picture in its file, "frame 3, "; keeps a picture of where they differ.
void compare_pictures(Differences& differences, const std::string& place, const RgbaImage& first,
                      const RgbaImage& second);
void compare_films(Differences& differences, const std::string& name, const std::string& first,
                   const std::string& second);

// The values of a file as bytes that do not depend on the encoding of pictures, for digests.
std::string encoded_values(const std::string& name, const std::string& bytes);

} // namespace pantin
