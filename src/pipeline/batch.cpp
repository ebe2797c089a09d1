// SPDX-License-Identifier: MIT
// One page to one line of the output, with its failure if it has one; tasks shared out over threads, their
// results handed on in order (docs/batch.md).
#include "pipeline/batch.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <map>
#include <mutex>
#include <new>
#include <system_error>

#include "core/file.hpp"
#include "core/json.hpp"
#include "core/thread_pool.hpp"
#include "formats/file_names.hpp"
#include "formats/identification_file.hpp"

namespace pantin {

namespace fs = std::filesystem;

namespace {

// --- one page ----------------------------------------------------------------------------------------------

// identification.json belongs to this run once the character has come past identification.
std::string type_of(const fs::path& folder, const std::string& status) {
    if (status != "ok" && !status.starts_with("rig: ") && !status.starts_with("render: ")) return "";
    const fs::path file = folder / file_names::identification;
    try {
        return reference_from_json(read_text(file), file.string());
    } catch (const Error&) {
        return ""; // of a former run, and changed by hand
    }
}

void describe_page(BatchResult& result, const Page& page, const fs::path& out) {
    result.remarks = page.remarks;
    for (const PageCharacter& c : page.characters)
        result.characters.push_back({c.folder, c.status, type_of(out / c.folder, c.status), c.warnings});
    const bool any = std::any_of(page.characters.begin(), page.characters.end(),
                                 [](const PageCharacter& c) { return c.status == "ok"; });
    if (any) return;
    result.status =
        page.characters.empty() ? "error: page.json lists no character" : page.characters.front().status;
    result.code = static_cast<int>(ErrorKind::not_animated);
}

// The page.json of a run that was finished, from the same picture. `detect` alone writes a page.json, too,
// but no GLB.
std::optional<Page> finished_page(const fs::path& image, const fs::path& out, const Settings& settings) {
    std::error_code ignored;
    if (!fs::exists(out / file_names::page, ignored)) return std::nullopt;
    try {
        const Page page = read_page(out / file_names::page);
        bool finished = page.source == image.filename() &&
                        page.rotate == settings.rotate.value_or(page.rotate) && !page.characters.empty();
        for (const PageCharacter& c : page.characters)
            finished = finished && c.status != unfinished_status &&
                       (c.status != "ok" || fs::exists(out / c.folder / file_names::glb, ignored));
        return finished ? std::optional(page) : std::nullopt;
    } catch (const Error&) {
        return std::nullopt; // not ours, or broken: done again
    }
}

void set_failure(BatchResult& result, const std::string& message, ErrorKind kind) {
    result.characters.clear();
    result.remarks.clear();
    result.skipped = false;
    result.status = "error: " + message;
    result.code = static_cast<int>(kind);
}

void animate_or_skip(const fs::path& image, const fs::path& out, const Settings& settings, bool skip_done,
                     Networks& networks, BatchResult& result) {
    if (const std::optional<Page> done = skip_done ? finished_page(image, out, settings) : std::nullopt) {
        result.skipped = true;
        return describe_page(result, *done, out);
    }
    try {
        describe_page(result, animate(image, out, settings, networks), out);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::not_animated) throw;
        describe_page(result, read_page(out / file_names::page), out);
    }
}

} // namespace

void set_failure(BatchResult& result) {
    try {
        throw;
    } catch (const Error& error) {
        set_failure(result, error.what(), error.kind());
    } catch (const CharacterRejected& rejected) {
        set_failure(result, rejected.step() + ": " + rejected.what(), ErrorKind::not_animated);
    } catch (const std::bad_alloc&) {
        set_failure(result, "out of memory", ErrorKind::internal);
    } catch (const std::exception& error) {
        set_failure(result, std::string("internal error: ") + error.what(), ErrorKind::internal);
    }
}

void run_batch_page(const fs::path& image, const fs::path& out, const Settings& settings, bool skip_done,
                    Networks& networks, BatchResult& result) {
    const auto start = std::chrono::steady_clock::now();
    try {
        animate_or_skip(image, out, settings, skip_done, networks, result);
    } catch (...) {
        set_failure(result);
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string batch_line(const BatchResult& result, bool with_seconds) {
    const auto text_or_null = [](const std::optional<std::string>& text) {
        return text ? Json(*text) : Json(nullptr);
    };
    Json line = {{"image", text_or_null(result.image)},
                 {"out", text_or_null(result.out)},
                 {"status", result.status},
                 {"code", result.code}};
    if (result.skipped) line["skipped"] = true;
    if (!result.remarks.empty()) line["remarks"] = result.remarks;
    line["characters"] = Json::array();
    for (const BatchCharacter& c : result.characters) {
        Json item = {{"folder", c.folder},
                     {"status", c.status},
                     {"type", c.type.empty() ? Json(nullptr) : Json(c.type)}};
        for (const Warning& warning : c.warnings) item["warnings"].push_back(row_of(warning.kind).name);
        line["characters"].push_back(item);
    }
    if (with_seconds) line["seconds"] = std::rint(1000 * result.seconds) / 1000;
    return to_compact_json_text(line);
}

// --- all pages ---------------------------------------------------------------------------------------------

namespace {

// Workers that take tasks in order and hand over results in order; how far a fast one may run ahead is
// limited, so that a slow task does not let results pile up.
class OrderedWorkerPool {
public:
    OrderedWorkerPool(int threads, const std::function<BatchTask()>& next,
                      const std::function<bool(const BatchResult&)>& write)
        : ahead_(2 * static_cast<std::size_t>(threads)), next_(next), write_(write) {}

    // What each thread does.
    void work() {
        std::size_t number = 0;
        while (const BatchTask task = take(number)) deliver(number, task());
    }

private:
    // Empty: there is no more to do.
    BatchTask take(std::size_t& number) {
        const std::lock_guard turn(input_);
        {
            std::unique_lock lock(output_);
            space_.wait(lock, [&] { return stopped_ || taken_ < written_ + ahead_; });
            if (stopped_) return {};
        }
        if (ended_) return {};
        ended_ = true;            // should it throw
        BatchTask task = next_(); // may wait for the input; others deliver in the meantime
        ended_ = !task;
        number = taken_++;
        return task;
    }

    void deliver(std::size_t number, BatchResult result) {
        const std::lock_guard lock(output_);
        waiting_.emplace(number, std::move(result));
        for (; !stopped_ && waiting_.count(written_) != 0; ++written_) {
            const BatchResult next = std::move(waiting_.at(written_));
            waiting_.erase(written_);
            stopped_ = true; // should it throw
            space_.notify_all();
            stopped_ = !write_(next);
        }
        space_.notify_all();
    }

    const std::size_t ahead_;
    const std::function<BatchTask()>& next_;
    const std::function<bool(const BatchResult&)>& write_;
    std::mutex input_, output_;
    // Under input_:
    std::size_t taken_ = 0;
    bool ended_ = false;
    // Under output_:
    std::condition_variable space_;
    std::map<std::size_t, BatchResult> waiting_; // for those before them
    std::size_t written_ = 0;
    bool stopped_ = false;
};

} // namespace

void run_in_order(int threads, const std::function<BatchTask()>& next,
                  const std::function<bool(const BatchResult&)>& write) {
    OrderedWorkerPool pool(threads, next, write);
    parallel_for(threads, threads, [&](int) { pool.work(); });
}

} // namespace pantin
