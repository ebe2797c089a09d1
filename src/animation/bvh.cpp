// SPDX-License-Identifier: MIT
// Biovision hierarchy files to joints, channels and frames. Programs write them in many ways: what is
// understood beyond the format's letter is used and told in a line (Motion::repairs).
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "core/plural.hpp"
#include "pantin/error.hpp"
#include "pantin/motion.hpp"

namespace pantin {
namespace {

constexpr std::size_t most_joints = 2000, most_frames = 1'000'000, most_values = 100'000'000;
constexpr double usual_frame_time = 1.0 / 30;
constexpr double far_from_rest = 15; // degrees that no joint turns from one frame to the next

struct ChannelName {
    std::string_view name;
    Channel channel;
};
constexpr std::array<ChannelName, 9> channel_names = {{{"Xposition", Channel::x_position},
                                                       {"Yposition", Channel::y_position},
                                                       {"Zposition", Channel::z_position},
                                                       {"Xrotation", Channel::x_rotation},
                                                       {"Yrotation", Channel::y_rotation},
                                                       {"Zrotation", Channel::z_rotation},
                                                       {"Xscale", Channel::scale},
                                                       {"Yscale", Channel::scale},
                                                       {"Zscale", Channel::scale}}};

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool same_letters(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lower(x) == lower(y); });
}

// Values that are no numbers, as C libraries write them: nan, -nan(ind), 1.#QNAN, inf, -1.#IND.
bool is_not_a_number(std::string_view word) {
    std::string text;
    for (const char c : word) text += lower(c);
    const std::string_view unsigned_text =
        std::string_view(text).substr(text.starts_with('-') || text.starts_with('+') ? 1 : 0);
    return unsigned_text.starts_with("nan") || unsigned_text == "inf" || unsigned_text == "infinity" ||
           unsigned_text.starts_with("1.#");
}

// The number that a word is; a decimal comma, as some systems write it, stands for the point.
std::optional<double> number_of(std::string_view word) {
    std::string text(word.substr(word.starts_with('+') ? 1 : 0));
    if (text.ends_with(',')) text.pop_back(); // between two values
    if (std::count(text.begin(), text.end(), ',') == 1 && text.find('.') == std::string::npos)
        std::replace(text.begin(), text.end(), ',', '.');
    double value = 0;
    const char *first = text.data(), *last = first + text.size();
    const auto [end, error] = std::from_chars(first, last, value);
    if (text.empty() || error != std::errc() || end != last || !std::isfinite(value)) return std::nullopt;
    return value;
}

class Parser {
public:
    Parser(std::string_view text, const std::string& file) : text_(text), file_(file) {
        if (text_.starts_with("\xEF\xBB\xBF")) begin_ = 3;
        using namespace std::string_view_literals;
        if (text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF") || text_.starts_with("H\0"sv) ||
            text_.starts_with("\0"sv))
            fail("the text is UTF-16 or UTF-32; save it as UTF-8");
    }

    Motion parse() {
        expect("HIERARCHY");
        expect("ROOT");
        tree(name_up_to_brace("the name of the root"));
        while (same_letters(peek(), "ROOT")) {
            next("");
            tree(name_up_to_brace("the name of a root"));
        }
        expect("MOTION");
        read_head();
        read_values();
        tell_of_frames();
        mend_values();
        leave_out_rest_frame();
        return std::move(motion_);
    }

private:
    [[noreturn]] void fail(const std::string& fact) const {
        const auto line =
            1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(begin_), '\n');
        throw Error(ErrorKind::input, file_ + ": line " + std::to_string(line) + ": " + fact);
    }

    // --- words
    // -----------------------------------------------------------------------------------------------

    // The next word, without taking it; "" at the end. All control characters are space, so is the Ctrl-Z
    // that ends some files.
    std::string_view peek() {
        while (begin_ < text_.size() && static_cast<unsigned char>(text_[begin_]) <= ' ') ++begin_;
        std::size_t end = begin_;
        while (end < text_.size() && static_cast<unsigned char>(text_[end]) > ' ') ++end;
        return text_.substr(begin_, end - begin_);
    }
    std::string next(const std::string& what) {
        const std::string_view word = peek();
        if (word.empty()) fail("the file ends before " + what);
        begin_ += word.size();
        return std::string(word);
    }
    void expect(std::string_view wanted) {
        const std::string_view word = peek();
        if (!same_letters(word, wanted))
            fail("'" + std::string(wanted) + "' is expected, not '" + std::string(word.substr(0, 40)) + "'");
        begin_ += word.size();
    }
    // "Frames:", also without the colon, after a space, or with the number right behind it.
    void expect_label(std::string_view wanted) {
        const std::string_view word = peek();
        if (!same_letters(word.substr(0, wanted.size()), wanted))
            fail("'" + std::string(wanted) + ":' is expected, not '" + std::string(word.substr(0, 40)) + "'");
        begin_ += wanted.size();
        if (peek().starts_with(':')) ++begin_;
    }
    double number(const std::string& what) {
        const std::string_view word = peek();
        const std::optional<double> value = number_of(word);
        if (!value) fail(what + " is expected, not '" + std::string(word.substr(0, 40)) + "'");
        if (std::abs(*value) > 1e9) fail(std::string(word.substr(0, 40)) + " is out of range");
        begin_ += word.size();
        return *value;
    }
    // Names may hold spaces; none is "".
    std::string name_up_to_brace(const std::string& what) {
        peek();
        const std::size_t end = text_.find_first_of("{\n\r", begin_);
        if (end == std::string_view::npos) fail("the file ends before " + what);
        std::string name(text_.substr(begin_, end - begin_));
        begin_ = end;
        while (!name.empty() && static_cast<unsigned char>(name.back()) <= ' ') name.pop_back();
        return name;
    }

    // --- joints
    // ----------------------------------------------------------------------------------------------

    // Braces are counted on a stack of our own: a file may nest as deep as it likes.
    void tree(const std::string& name) {
        std::vector<int> path;
        open(-1, name, path);
        while (!path.empty()) {
            const std::string word = next("the closing brace of '" +
                                          motion_.joints[static_cast<std::size_t>(path.back())].name + "'");
            if (word == "}") {
                path.pop_back();
            } else if (same_letters(word, "JOINT")) {
                open(path.back(), name_up_to_brace("the name of a joint"), path);
            } else if (same_letters(word, "End")) {
                expect("Site");
                name_up_to_brace("an end site"); // some programs name it
                open(path.back(), "", path);
            } else {
                fail("JOINT, End Site or } is expected, not '" + word.substr(0, 40) + "'");
            }
        }
    }

    // From the opening brace to offset and channels, in either order.
    void open(int parent, const std::string& name, std::vector<int>& path) {
        if (motion_.joints.size() >= most_joints)
            fail("more than " + std::to_string(most_joints) + " joints");
        expect("{");
        MotionJoint joint;
        joint.name = name;
        joint.parent = parent;
        joint.first_channel = motion_.channels;
        if (same_letters(peek(), "CHANNELS")) channels(joint);
        expect("OFFSET");
        joint.offset.x = number("an offset");
        joint.offset.y = number("an offset");
        joint.offset.z = number("an offset");
        if (joint.channels.empty() && same_letters(peek(), "CHANNELS")) channels(joint);
        motion_.channels += joint.channels.size();
        path.push_back(static_cast<int>(motion_.joints.size()));
        motion_.joints.push_back(std::move(joint));
    }
    void channels(MotionJoint& joint) {
        expect("CHANNELS");
        const double count = number("the number of channels");
        if (!(count >= 0 && count <= 9) || count != std::floor(count)) fail("a joint has 0 to 9 channels");
        for (int i = 0; i < static_cast<int>(count); ++i) {
            const std::string word = next("a channel");
            const auto found = std::find_if(channel_names.begin(), channel_names.end(),
                                            [&](const ChannelName& c) { return same_letters(c.name, word); });
            if (found == channel_names.end()) fail("'" + word.substr(0, 40) + "' is no channel");
            joint.channels.push_back(found->channel);
        }
    }

    // --- frames
    // ----------------------------------------------------------------------------------------------

    void read_head() {
        expect_label("Frames");
        declared_ = number("the number of frames");
        if (!(declared_ >= 0) || declared_ > most_frames || declared_ != std::floor(declared_))
            fail("there must be 1 to " + std::to_string(most_frames) + " frames");
        expect("Frame");
        expect_label("Time");
        motion_.frame_time = number("the time of a frame");
        if (motion_.frame_time == 0) {
            motion_.frame_time = usual_frame_time;
            motion_.repairs.push_back("a frame takes no time; 1/30 s is taken");
        }
        if (!(motion_.frame_time > 1e-4 && motion_.frame_time <= 10))
            fail("a frame must take 0.0001 to 10 seconds");
        if (motion_.channels == 0) fail("no joint has a channel");
        for (const MotionJoint& joint : motion_.joints)
            if (std::count(joint.channels.begin(), joint.channels.end(), Channel::scale) > 0) {
                motion_.repairs.push_back("scales are not followed");
                break;
            }
    }

    void read_values() {
        const auto expected = static_cast<std::size_t>(declared_) * motion_.channels;
        motion_.values.reserve(std::min(expected, text_.size() / 2));
        while (!peek().empty()) {
            if (motion_.values.size() >= most_values) fail("too many values");
            if (is_not_a_number(peek())) {
                motion_.values.push_back(std::numeric_limits<double>::quiet_NaN());
                begin_ += peek().size();
            } else {
                motion_.values.push_back(number("a value of the motion"));
            }
        }
        const std::size_t rest = motion_.values.size() % motion_.channels;
        if (motion_.values.empty()) fail("there is no frame");
        if (rest != 0)
            fail("the last frame has " + std::to_string(rest) + " of " +
                 count_of(static_cast<long>(motion_.channels), "value"));
        if (motion_.frames() > most_frames) fail("more than " + std::to_string(most_frames) + " frames");
    }

    void tell_of_frames() {
        if (static_cast<double>(motion_.frames()) == declared_) return;
        motion_.repairs.push_back(count_of(static_cast<long>(motion_.frames()), "frame") +
                                  (motion_.frames() == 1 ? " is" : " are") + " there, not " +
                                  std::to_string(static_cast<long>(declared_)) +
                                  " as declared; all are used");
    }

    // What is no number stays as it was in the frame before; in the first frames, as it will be.
    void mend_values() {
        long mended = 0;
        const std::size_t n = motion_.channels;
        for (std::size_t c = 0; c < n; ++c) {
            double last = std::numeric_limits<double>::quiet_NaN();
            for (std::size_t i = c; i < motion_.values.size() && std::isnan(last); i += n)
                last = motion_.values[i];
            if (std::isnan(last)) last = 0;
            for (std::size_t i = c; i < motion_.values.size(); i += n) {
                if (std::isnan(motion_.values[i])) motion_.values[i] = last, ++mended;
                last = motion_.values[i];
            }
        }
        if (mended == 0) return;
        if (static_cast<std::size_t>(mended) == motion_.values.size())
            fail("no value of the motion is a number");
        motion_.repairs.push_back(count_of(mended, "value") + (mended == 1 ? " is" : " are") +
                                  " no number; the frame before stands for " + (mended == 1 ? "it" : "them"));
    }

    // Many recordings begin with one frame of the hierarchy's own pose.
    void leave_out_rest_frame() {
        if (motion_.frames() < 3) return;
        double first = 0, second = 0;
        for (const MotionJoint& joint : motion_.joints)
            for (std::size_t c = 0; c < joint.channels.size(); ++c) {
                const Channel channel = joint.channels[c];
                if (channel != Channel::x_rotation && channel != Channel::y_rotation &&
                    channel != Channel::z_rotation)
                    continue;
                first = std::max(first, std::abs(motion_.values[joint.first_channel + c]));
                second =
                    std::max(second, std::abs(motion_.values[motion_.channels + joint.first_channel + c]));
            }
        if (first != 0 || second < far_from_rest) return;
        motion_.values.erase(motion_.values.begin(),
                             motion_.values.begin() + static_cast<std::ptrdiff_t>(motion_.channels));
        motion_.repairs.push_back("the first frame is the pose at rest and is left out");
    }

    std::string_view text_;
    const std::string& file_;
    std::size_t begin_ = 0;
    double declared_ = 0; // frames
    Motion motion_;
};

} // namespace

Motion parse_bvh(std::string_view text, const std::string& file) { return Parser(text, file).parse(); }

} // namespace pantin
