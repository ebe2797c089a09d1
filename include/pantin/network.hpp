// SPDX-License-Identifier: MIT
// The CNN inference kernel: tensors, weight files, layers. What PyTorch computes, on one CPU, with the same
// bits on every machine and for any number of threads.
//
// Determinism. Every output element of a convolution, a transposed convolution and a linear layer is one
// sequential chain of fused multiply-adds in fp32:
//     acc = bias;  for (input channel) for (kernel row) for (kernel column)  acc = fma(weight, input, acc)
// A tap outside the image contributes fma(weight, 0, acc). Vector code and threads work on several elements
// at once and never split a chain, so every SIMD variant returns the same bits. Weights are finite (checked
// on load). `network/naive_layers.hpp` holds the plain loops that define each layer; the tests compare the
// two.
//
// Shapes are [batch][channels][height][width]; a layer's result has the input's batch. Errors: a wrong shape
// is Error(weights) with one line that names it, because shapes come from weight files. The layers compute
// what PyTorch's of the name in their comment do; thesis 3.1 introduces them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pantin {
class ThreadPool; // core/thread_pool.hpp
}

namespace pantin::network {

// --- tensors ---------------------------------------------------------------------------------------------

// Memory of a tensor. Blocks that tensors give back are kept and used again: the layers of a network need
// the same few sizes over and over, and fresh memory costs more than many a layer. Each block has spare
// elements behind its end, so that the last vector may be read whole.
struct MemoryBlock {
    void* data = nullptr;
    std::size_t capacity = 0; // elements of four bytes
};
// A block of at least that many elements and the spare ones, whose first spare ones are 0. std::bad_alloc.
// Own.
MemoryBlock take_block(std::size_t size);
void give_back(const MemoryBlock& block) noexcept;

template <class Element> class Buffer {
    static_assert(sizeof(Element) == 4);

public:
    Buffer() = default; // empty
    // size: elements of undefined content. std::bad_alloc. Own.
    explicit Buffer(std::size_t size) : block_(size ? take_block(size) : MemoryBlock{}), size_(size) {}
    Buffer(const Buffer& other) : Buffer(other.size_) { std::copy(other.begin(), other.end(), begin()); }
    Buffer(Buffer&& other) noexcept
        : block_(std::exchange(other.block_, {})), size_(std::exchange(other.size_, 0)) {}
    Buffer& operator=(Buffer other) noexcept {
        std::swap(block_, other.block_);
        std::swap(size_, other.size_);
        return *this;
    }
    ~Buffer() {
        if (block_.data) give_back(block_);
    }

    // size() elements. No errors. Own.
    Element* begin() { return static_cast<Element*>(block_.data); }
    Element* end() { return begin() + size_; }
    const Element* begin() const { return static_cast<const Element*>(block_.data); }
    const Element* end() const { return begin() + size_; }
    std::size_t size() const { return size_; }
    bool operator==(const Buffer& other) const {
        return std::equal(begin(), end(), other.begin(), other.end());
    }

private:
    MemoryBlock block_;
    std::size_t size_ = 0;
};

// The number of elements of a tensor. Error(weights) when an extent is negative or there are too many. Own.
std::size_t element_count(int batch, int channels, int height, int width);

// Row-major [batch][channel][row][column], as PyTorch's contiguous NCHW.
template <class Element> class BasicTensor {
public:
    BasicTensor() = default; // of no element
    // Filled with `value`. Extents ≥ 0. std::bad_alloc. PyTorch's full.
    BasicTensor(int batch, int channels, int height, int width, Element value = 0)
        : BasicTensor(uninitialised(batch, channels, height, width)) {
        std::fill(begin(), end(), value);
    }
    // The same with undefined content, for layers that write every element. std::bad_alloc. PyTorch's empty.
    static BasicTensor uninitialised(int batch, int channels, int height, int width) {
        BasicTensor tensor;
        tensor.data_ = Buffer<Element>(element_count(batch, channels, height, width));
        tensor.batch_ = batch;
        tensor.channels_ = channels;
        tensor.height_ = height;
        tensor.width_ = width;
        return tensor;
    }

    // Extents, and the number of elements of a channel and of all. No errors. Own.
    int batch() const { return batch_; }
    int channels() const { return channels_; }
    int height() const { return height_; }
    int width() const { return width_; }
    std::size_t plane_size() const { return static_cast<std::size_t>(height_) * width_; }
    std::size_t size() const { return data_.size(); }
    // Whether all four extents are equal. No errors. Own.
    bool same_shape(const BasicTensor& other) const {
        return batch_ == other.batch_ && channels_ == other.channels_ && height_ == other.height_ &&
               width_ == other.width_;
    }

    // A channel of a batch entry, height·width elements by rows; its element at row y, column x; all elements
    // in memory order. Indices are not checked. Own.
    Element* plane(int n, int c) {
        return data_.begin() + (static_cast<std::size_t>(n) * channels_ + c) * plane_size();
    }
    const Element* plane(int n, int c) const {
        return data_.begin() + (static_cast<std::size_t>(n) * channels_ + c) * plane_size();
    }
    Element& operator()(int n, int c, int y, int x) {
        return plane(n, c)[static_cast<std::size_t>(y) * width_ + x];
    }
    Element operator()(int n, int c, int y, int x) const {
        return plane(n, c)[static_cast<std::size_t>(y) * width_ + x];
    }
    Element* data() { return data_.begin(); }
    const Element* data() const { return data_.begin(); }
    auto begin() { return data_.begin(); }
    auto end() { return data_.end(); }
    auto begin() const { return data_.begin(); }
    auto end() const { return data_.end(); }
    bool operator==(const BasicTensor&) const = default;

private:
    int batch_ = 0, channels_ = 0, height_ = 0, width_ = 0;
    Buffer<Element> data_;
};

using Tensor = BasicTensor<float>;

// --- where it runs ---------------------------------------------------------------------------------------

// avx512: AVX-512F; vnni: AVX-512F, BW and VNNI; neon_dot: Armv8.2's dot product.
enum class Simd { baseline, sse41, avx2, avx512, vnni, neon, neon_dot };
inline constexpr Simd all_simd[] = {Simd::baseline, Simd::sse41, Simd::avx2,    Simd::avx512,
                                    Simd::vnni,     Simd::neon,  Simd::neon_dot};

// Its name as PANTIN_SIMD takes it. No errors. Own.
std::string_view name_of(Simd simd);
// Compiled in, and this processor can run it. No errors. Own.
bool simd_supported(Simd simd);
// The fastest supported one. Own. The environment variable PANTIN_SIMD (a name of the above) forces another;
// an unknown or unsupported value is Error(usage).
Simd best_simd();

// Threads and instruction set of a forward pass. Results depend on neither.
class Runtime {
public:
    // threads: 1 and less is the caller alone. Error(usage) when this processor has no such instructions.
    // Own.
    explicit Runtime(int threads = 1, Simd simd = best_simd());
    ~Runtime();
    Runtime(const Runtime&) = delete;
    Runtime& operator=(const Runtime&) = delete;

    // What it was made with; at least one thread. No errors. Own.
    int threads() const;
    Simd simd() const { return simd_; }
    // Calls task(0) … task(count − 1), each once, in any order, on all threads; returns when all are done.
    // The first exception of a task is rethrown. One loop at a time. Own.
    void parallel_for(int count, const std::function<void(int)>& task) const;

    // At least `count` elements of four bytes of undefined content, valid until the next call: the layers'
    // working memory. std::bad_alloc. Own.
    template <class Element> Element* scratch(std::size_t count) const {
        static_assert(sizeof(Element) == 4);
        return static_cast<Element*>(scratch_memory(count));
    }

private:
    void* scratch_memory(std::size_t count) const;

    Simd simd_;
    std::unique_ptr<ThreadPool> pool_;
    mutable MemoryBlock scratch_;
};

// --- weight files ----------------------------------------------------------------------------------------

// The safetensors format (8 bytes of header length, JSON header, tensor bytes), bounds-checked: anything
// malformed is Error(weights) naming the source and, where there is one, the tensor. Little-endian F32, F16,
// I8, U8, I32 and I64 tensors can be read; tensors of other types are allowed in the file. The bytes must
// outlive the object.
class WeightFile {
public:
    // bytes: the whole file; source: its name in messages. Error(weights) when it is malformed. safetensors.
    WeightFile(std::span<const unsigned char> bytes, std::string source);

    // The name in messages. No errors. Own.
    const std::string& source() const { return source_; }
    // Whether there is such a tensor; all their names in alphabetical order. No errors. safetensors.
    bool contains(const std::string& name) const { return entries_.count(name) != 0; }
    std::vector<std::string> names() const;
    // Extents of a tensor, outermost first. Error(weights) when it is missing. safetensors.
    std::vector<std::int64_t> shape(const std::string& name) const;
    // Whether `__metadata__` has the key. No errors. safetensors.
    bool has_metadata(const std::string& key) const { return metadata_.count(key) != 0; }
    // Value of `__metadata__`. Error(weights) when it is missing. safetensors.
    const std::string& metadata(const std::string& key) const;
    // The tensor as floats, row-major. Error(weights) when it is missing, of another shape or type, or has a
    // value that is not finite. safetensors.
    std::vector<float> read(const std::string& name, const std::vector<std::int64_t>& expected_shape) const;
    // The same of whole numbers. Number: std::int8_t of a tensor of type I8, std::uint8_t of U8, std::int32_t
    // of I32, std::int64_t of I64. Error(weights) when it is missing or of another shape or type.
    template <class Number>
    std::vector<Number> read_integers(const std::string& name,
                                      const std::vector<std::int64_t>& expected_shape) const;
    // Throws Error(weights): the source and the fact, as every message about this file. Own.
    [[noreturn]] void fail(const std::string& fact) const;

private:
    struct Entry {
        std::string type;
        std::vector<std::int64_t> shape;
        std::size_t begin = 0, end = 0; // in bytes_
    };
    const Entry& entry(const std::string& name) const;
    const Entry& entry(const std::string& name, const std::vector<std::int64_t>& expected_shape) const;
    void check_tiling(std::size_t data) const;

    std::span<const unsigned char> bytes_;
    std::string source_;
    std::map<std::string, std::string> metadata_;
    std::map<std::string, Entry> entries_;
};

// Bits of an IEEE 754 binary16 to binary32, exact. No errors. IEEE 754-2019, 3.4.
float half_to_float(std::uint16_t half);

// --- layers with weights ---------------------------------------------------------------------------------

struct ConvolutionOptions {
    int stride = 1, padding = 0, dilation = 1, groups = 1;
    int output_padding = 0; // transposed convolution only
    bool relu = false;      // max(0, ·) on the result
};

// Filters of a convolution, as PyTorch stores them: [out][in / groups][row][column]; of a transposed
// convolution: [in][out / groups][row][column].
struct Filters {
    int out = 0, in = 0, height = 0, width = 0; // of the whole layer, all groups
    std::vector<float> weights;
    std::vector<float> bias; // [out]
};
// Inference-time batch normalisation, one value per output channel.
struct BatchNorm {
    std::vector<float> gamma, beta, mean, variance;
    double epsilon = 1e-5;
};
// The normalisation folded into filters [out][…]: w·γ/√(σ²+ε) and β + (b − μ)·γ/√(σ²+ε), in double, rounded
// once. Error(weights) when a list has not one value for each output channel or σ²+ε is not positive. Ioffe &
// Szegedy 2015, Alg. 2.
Filters fold(Filters filters, const BatchNorm& norm);

// Weights of a layer, repacked for the kernel: [block of rows][in][tap][row of the block].
struct PackedFilters;

// Convolution in PyTorch's sense (cross-correlation), zero padding (thesis Fig. 3.2; Conv2d).
class Convolution {
public:
    // Error(weights) when extents, lists and groups do not fit together. Conv2d.
    Convolution(Filters filters, const ConvolutionOptions& options);
    Convolution(Convolution&&) noexcept;
    Convolution& operator=(Convolution&&) noexcept;
    ~Convolution();
    // [n][in][h][w] to [n][out][out_height(h)][out_width(w)]. Error(weights) when the channels differ or the
    // image is too small. Conv2d.
    Tensor forward(const Tensor& input, const Runtime& runtime) const;
    // Multiply-accumulates of one image of that size in pixels. No errors. Own.
    std::int64_t operations(int height, int width) const;
    // ⌊(extent + 2·padding − dilation·(kernel − 1) − 1) / stride⌋ + 1 pixels; channels. No errors. Conv2d.
    int out_height(int height) const;
    int out_width(int width) const;
    int out_channels() const { return filters_.out; }

private:
    Filters filters_; // without weights, they live in packed_
    ConvolutionOptions options_;
    std::unique_ptr<PackedFilters> packed_;
};

// The chain of an output element runs over the taps that reach it alone: those whose stride fits
// (ConvTranspose2d).
class TransposedConvolution {
public:
    // Error(weights) when extents, lists and groups do not fit together. ConvTranspose2d.
    TransposedConvolution(Filters filters, const ConvolutionOptions& options);
    TransposedConvolution(TransposedConvolution&&) noexcept;
    TransposedConvolution& operator=(TransposedConvolution&&) noexcept;
    ~TransposedConvolution();
    // [n][in][h][w] to [n][out][(h − 1)·stride − 2·padding + dilation·(kernel − 1) + output_padding + 1][…].
    // Error(weights) when the channels differ or nothing is left. ConvTranspose2d.
    Tensor forward(const Tensor& input, const Runtime& runtime) const;

private:
    struct Phase;
    Filters filters_;
    ConvolutionOptions options_;
    std::vector<Phase> phases_; // one per residue of the output position modulo the stride
};

// y = W·x + b on the flattened [channel][row][column] of each batch entry; result [batch][out][1][1].
class Linear {
public:
    // weights: [out][in], bias: [out]. Error(weights) when they have other sizes. Thesis Eq. 3.1; Linear.
    Linear(int out, int in, const std::vector<float>& weights, std::vector<float> bias);
    // Error(weights) when a batch entry has not `in` values. Thesis Eq. 3.1; Linear.
    Tensor forward(const Tensor& input, const Runtime& runtime) const;

private:
    int out_, in_;
    std::vector<float> tiles_; // of the transposed weights, padded to whole vectors (linear.cpp)
    std::vector<float> bias_;  // padded likewise
};

// --- layers without weights ------------------------------------------------------------------------------

// [n][c][h][w] to [n][c][⌊(h + 2·padding − kernel) / stride⌋ + 1][…]. Padded taps do not count. With
// `ceil_mode` a last window that starts inside the image or its left padding may reach beyond the right one.
// Error(weights) when the window is impossible or larger than the image. Thesis Fig. 3.3; MaxPool2d.
Tensor max_pool(const Tensor& input, int kernel, int stride, int padding = 0, bool ceil_mode = false);
// The same shapes and errors. Sum in raster order in double, divided by the number of taps inside the image.
// AvgPool2d with count_include_pad = false.
Tensor average_pool(const Tensor& input, int kernel, int stride, int padding = 0);
// [n][c][h][w] to [n][c][1][1]. Error(weights) when the image is empty. AdaptiveAvgPool2d(1),
// AdaptiveMaxPool2d(1).
Tensor global_average_pool(const Tensor& input);
Tensor global_max_pool(const Tensor& input);

// x > 0 ? x : 0, in place. No errors. Thesis Eq. 3.2; ReLU.
void relu(Tensor& x);
// x becomes relu(x + y), x + y. Error(weights) when the shapes differ. The sum of a residual block (He et al.
// 2016, Eq. 1; thesis Fig. 4.4).
void add_relu(Tensor& x, const Tensor& y);
void add(Tensor& x, const Tensor& y);
// [n][a][h][w] and [n][b][h][w] to [n][a + b][h][w]. Error(weights) when the other extents differ. cat.
Tensor concatenate(const Tensor& a, const Tensor& b);
// The input's shape, left and right exchanged. No errors. flip.
Tensor mirrored(const Tensor& input);
// To height × width pixels. Error(weights) when one of the sizes is 0. interpolate, mode "nearest".
Tensor resize_nearest(const Tensor& input, int height, int width);
// x += y, resized to x's size as above. Error(weights) when batch or channels differ. The feature pyramid's
// top-down pathway (Lin et al. 2017, 3).
void add_nearest(Tensor& x, const Tensor& y);
// To height × width pixels, without antialiasing. Error(weights) when one of the sizes is 0. interpolate,
// mode "bilinear", align_corners = false.
Tensor resize_bilinear(const Tensor& input, int height, int width, const Runtime& runtime);
// The same shapes and errors; align_corners = true: the corner pixels' centres stay where they are.
Tensor resize_corners(const Tensor& input, int height, int width);
// 1 / (1 + exp(−x)) of each element in double by math::exp, rounded once. No errors. Thesis Eq. 3.3; Sigmoid.
Tensor sigmoid(const Tensor& logits);
// Over channels, the input's shape: exp(x − max) in double by math::exp, summed in the order of channels,
// rounded once. No errors. Thesis Eq. 3.5; Softmax.
Tensor softmax(const Tensor& logits, const Runtime& runtime);

} // namespace pantin::network
