// SPDX-License-Identifier: MIT
// Files of tests in processes of their own, several at a time.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace pantin::test {

// Test cases.
struct Counts {
    std::size_t passed = 0, failed = 0;
};
// Calls run(file) for each file in a child process, at most `jobs` at once, begun in their order. What a
// child prints is printed whole, when it ends. A child that dies counts as one failure. Returns the sums.
Counts run_in_processes(const std::vector<std::string>& files, int jobs,
                        const std::function<Counts(const std::string&)>& run);

} // namespace pantin::test
