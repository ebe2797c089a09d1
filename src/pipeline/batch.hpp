// SPDX-License-Identifier: MIT
// Many pages in one process (docs/batch.md): one page as a line of the output, and the threads that share the
// pages out.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pantin/pipeline.hpp"

namespace pantin {

struct BatchCharacter {
    std::string folder, status; // as in page.json
    std::string type;           // the reference it moves like; empty: it did not get so far
    std::vector<Warning> warnings{};
};

// What the output says about a line of the input.
struct BatchResult {
    std::optional<std::string> image, out; // as the line gives them; none when the line cannot be understood
    std::string status =
        "ok";             // a character was animated; or "step: reason" of the first one, or "error: message"
    int code = 0;         // the exit code of `pantin animate`
    bool skipped = false; // was done already
    std::vector<std::string> remarks; // of page.json
    std::vector<BatchCharacter> characters;
    double seconds = 0;
    double share = -1; // of the input up to this line, for the progress bar; negative: unknown
};

// `animate`, with failures in the result. With `skip_done` a page that a former run has finished is left as
// it is.
void run_batch_page(const std::filesystem::path& image, const std::filesystem::path& out,
                    const Settings& settings, bool skip_done, Networks& networks, BatchResult& result);

// Puts the exception that is being handled into the result.
void set_failure(BatchResult& result);

// One line of JSON, without its end.
std::string batch_line(const BatchResult& result, bool with_seconds);

using BatchTask = std::function<BatchResult()>;

// Takes tasks from `next` until it gives an empty one, runs them in `threads` threads, and hands the results
// to `write` in the order of the tasks, each as soon as all before it are there. Neither is called by two
// threads at once. Ends early when `write` returns false. No task begins before all but the last 2 · threads
// are written, so a slow one does not let results pile up. Tasks throw nothing; exceptions of `next` and
// `write` come through.
void run_in_order(int threads, const std::function<BatchTask()>& next,
                  const std::function<bool(const BatchResult&)>& write);

} // namespace pantin
