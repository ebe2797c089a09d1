// SPDX-License-Identifier: MIT
// H.264 in MP4 by the ffmpeg on the machine: raw frames through a socket, so that nothing but ffmpeg has to
// be there and no intermediate file is written. The bytes are ffmpeg's own and differ between its versions.
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/decimal.hpp"
#include "pantin/error.hpp"
#include "pantin/export.hpp"

extern char** environ;

namespace pantin {

namespace fs = std::filesystem;

namespace {

constexpr double least_seconds =
    3; // a film that does not loop by itself: the loop is shown as often as this needs

class Descriptor {
public:
    explicit Descriptor(int number = -1) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const { return number_; }
    void close() {
        if (number_ >= 0) ::close(number_);
        number_ = -1;
    }

private:
    int number_;
};

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// The frame on white, with even sides as 4:2:0 colour wants them; the last column and row are repeated.
std::vector<unsigned char> flattened(const RgbaImage& frame) {
    const int width = frame.width() + frame.width() % 2, height = frame.height() + frame.height() % 2;
    std::vector<unsigned char> bytes;
    bytes.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    const auto on_white = [](int value, int alpha) {
        return static_cast<unsigned char>((value * alpha + 255 * (255 - alpha) + 127) / 255);
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Rgba8 p = frame(std::min(x, frame.width() - 1), std::min(y, frame.height() - 1));
            for (const int value : {p.r, p.g, p.b}) bytes.push_back(on_white(value, p.a));
        }
    return bytes;
}

// False when the reader has gone away; MSG_NOSIGNAL keeps that from ending this program.
bool send_all(int socket, const std::vector<unsigned char>& bytes) {
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t sent = ::send(socket, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return false;
        done += static_cast<std::size_t>(sent);
    }
    return true;
}

std::string first_line(std::FILE* file) {
    char line[400] = "";
    std::rewind(file);
    if (!std::fgets(line, sizeof line, file)) return "";
    line[std::strcspn(line, "\n")] = 0;
    return line;
}

std::vector<std::string> arguments(const RgbaImage& frame, double fps, const fs::path& out) {
    const std::string size = std::to_string(frame.width() + frame.width() % 2) + "x" +
                             std::to_string(frame.height() + frame.height() % 2);
    return {"ffmpeg",
            "-nostdin",
            "-loglevel",
            "error",
            "-y",
            "-f",
            "rawvideo",
            "-pix_fmt",
            "rgb24",
            "-s",
            size,
            "-r",
            to_decimal(fps),
            "-i",
            "pipe:0",
            "-an",
            "-c:v",
            "libx264",
            "-crf",
            "18",
            "-pix_fmt",
            "yuv420p",
            "-movflags",
            "+faststart",
            "-f",
            "mp4",
            fs::absolute(out).string()};
}

// ffmpeg with `input` as its standard input and `messages` as its standard error.
pid_t start(std::vector<std::string> words, int input, int messages) {
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, messages, STDERR_FILENO);
    pid_t child = -1;
    const int failed = posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return failed == 0 ? child : -1;
}

bool ended_well(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return false;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

} // namespace

bool mp4_available() {
    const char* path = std::getenv("PATH");
    std::string folders = path ? path : "";
    for (std::size_t begin = 0; begin <= folders.size();) {
        const std::size_t end = std::min(folders.find(':', begin), folders.size());
        const fs::path program = fs::path(folders.substr(begin, end - begin)) / "ffmpeg";
        std::error_code ignored;
        if (::access(program.c_str(), X_OK) == 0 && fs::is_regular_file(program, ignored)) return true;
        begin = end + 1;
    }
    return false;
}

void write_mp4(const fs::path& file, const std::vector<RgbaImage>& frames, double fps) {
    if (frames.empty()) throw Error(ErrorKind::internal, "an animation without frames");
    const fs::path part = file.string() + ".part";
    const auto fail = [&](const std::string& what) {
        std::error_code ignored;
        fs::remove(part, ignored);
        throw Error(ErrorKind::output, file.string() + ": " + what);
    };
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) fail("cannot make a pipe to ffmpeg");
    Descriptor ours(ends[0]), theirs(ends[1]);
    const File messages(std::tmpfile(), std::fclose);
    if (!messages) fail("cannot make a temporary file");
    const pid_t ffmpeg = start(arguments(frames[0], fps, part), theirs.number(), fileno(messages.get()));
    if (ffmpeg < 0) fail("ffmpeg cannot be started");
    theirs.close();
    const double loop = static_cast<double>(frames.size()) / fps;
    const int loops = std::max(1, static_cast<int>(std::ceil(least_seconds / loop)));
    bool sent = true;
    for (int i = 0; sent && i < loops; ++i)
        for (std::size_t k = 0; sent && k < frames.size(); ++k)
            sent = send_all(ours.number(), flattened(frames[k]));
    ours.close();
    if (!ended_well(ffmpeg) || !sent) {
        const std::string reason = first_line(messages.get());
        fail("ffmpeg failed" + (reason.empty() ? "" : ": " + reason));
    }
    std::error_code error;
    fs::rename(part, file, error);
    if (error) fail(error.message());
}

} // namespace pantin
