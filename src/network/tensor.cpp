// SPDX-License-Identifier: MIT
// Memory of tensors: blocks that are given back are kept for the next layer. Ours.
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>
#include <mutex>
#include <new>

#include "network/vector_width.hpp"
#include "pantin/error.hpp"
#include "pantin/network.hpp"

namespace pantin::network {

// --- memory ----------------------------------------------------------------------------------------------

namespace {

using Block = MemoryBlock;

constexpr std::size_t most_kept = std::size_t{24} << 20; // bytes
constexpr std::size_t alignment = 64;                    // a cache line, and the widest vector
constexpr std::size_t element = 4;                       // bytes

// Blocks that no tensor holds at the moment.
class Store {
public:
    ~Store() {
        for (const auto& [capacity, block] : blocks_) std::free(block.data);
    }
    // The smallest kept block that is large enough but not half empty; else a new one.
    Block take(std::size_t capacity) {
        {
            const std::lock_guard lock(mutex_);
            const auto found = blocks_.lower_bound(capacity);
            if (found != blocks_.end() && found->first <= 2 * capacity) {
                const Block block = found->second;
                kept_ -= bytes_of(block);
                blocks_.erase(found);
                return block;
            }
        }
        const std::size_t bytes = (capacity * element + alignment - 1) / alignment * alignment;
        void* data = std::aligned_alloc(alignment, bytes);
        if (!data) throw std::bad_alloc();
        return {data, capacity};
    }
    void give_back(const Block& block) {
        const std::lock_guard lock(mutex_);
        if (kept_ + bytes_of(block) > most_kept) return std::free(block.data);
        blocks_.emplace(block.capacity, block);
        kept_ += bytes_of(block);
    }

private:
    static std::size_t bytes_of(const Block& block) { return block.capacity * element; }

    std::mutex mutex_;
    std::multimap<std::size_t, Block> blocks_; // by capacity
    std::size_t kept_ = 0;                     // bytes
};

// Never destroyed: tensors in static storage may be given back after it would be.
Store& store() {
    static Store& instance = *new Store;
    return instance;
}

} // namespace

MemoryBlock take_block(std::size_t size) {
    const MemoryBlock block = store().take(size + max_vector_width);
    std::memset(static_cast<unsigned char*>(block.data) + size * element, 0, max_vector_width * element);
    return block;
}

void give_back(const MemoryBlock& block) noexcept { store().give_back(block); }

std::size_t element_count(int batch, int channels, int height, int width) {
    if (batch < 0 || channels < 0 || height < 0 || width < 0)
        throw Error(ErrorKind::weights, "a network layer's result would have a negative extent");
    std::size_t count = 1;
    for (const int extent : {batch, channels, height, width}) {
        if (extent != 0 &&
            count > std::numeric_limits<std::size_t>::max() / 16 / static_cast<std::size_t>(extent))
            throw Error(ErrorKind::weights, "a network layer's result would be too large");
        count *= static_cast<std::size_t>(extent);
    }
    return count;
}

} // namespace pantin::network
