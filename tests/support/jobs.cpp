// SPDX-License-Identifier: MIT
#include "support/jobs.hpp"

#include <cstdio>
#include <map>
#include <stdexcept>

#include <stdlib.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/folders.hpp"

namespace pantin::test {

namespace {

// Where the children leave their counts, one place each.
class SharedCounts {
public:
    explicit SharedCounts(std::size_t count) : bytes_((count + 1) * sizeof(Counts)) {
        void* const memory = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (memory == MAP_FAILED) throw std::runtime_error("no shared memory");
        counts_ = static_cast<Counts*>(memory);
    }
    ~SharedCounts() { munmap(counts_, bytes_); }
    SharedCounts(const SharedCounts&) = delete;
    SharedCounts& operator=(const SharedCounts&) = delete;

    Counts& operator[](std::size_t index) { return counts_[index]; }

private:
    std::size_t bytes_;
    Counts* counts_;
};

void print_whole(const std::string& file) {
    const std::string text = read(file);
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
}

} // namespace

Counts run_in_processes(const std::vector<std::string>& files, int jobs,
                        const std::function<Counts(const std::string&)>& run) {
    const TemporaryFolder folder;
    SharedCounts counts(files.size());
    std::map<pid_t, std::size_t> running;
    const auto output = [&](std::size_t index) { return (folder / std::to_string(index)).string(); };
    Counts sum;
    const auto wait_for_one = [&] {
        int status = 0;
        const pid_t child = wait(&status);
        const auto found = running.find(child);
        if (found == running.end()) return;
        const std::size_t index = found->second;
        running.erase(found);
        print_whole(output(index));
        if (!WIFEXITED(status) || WEXITSTATUS(status) > 1) {
            std::printf("%s: the tests ended early, status %d\n", files[index].c_str(), status);
            ++counts[index].failed;
        }
        sum.passed += counts[index].passed;
        sum.failed += counts[index].failed;
    };
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (running.size() == static_cast<std::size_t>(jobs)) wait_for_one();
        std::fflush(stdout);
        const pid_t child = fork();
        if (child < 0) throw std::runtime_error("cannot fork");
        if (child == 0) {
            if (!freopen(output(i).c_str(), "w", stdout)) _exit(126);
            dup2(fileno(stdout), STDERR_FILENO);
            counts[i] = run(files[i]);
            std::fflush(nullptr);
            // exit() looks for leaks under a sanitizer; _exit() would not. The folder is the parent's to
            // remove.
            std::exit(counts[i].failed != 0);
        }
        running[child] = i;
    }
    while (!running.empty()) wait_for_one();
    return sum;
}

} // namespace pantin::test
