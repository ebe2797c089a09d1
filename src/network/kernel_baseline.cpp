// SPDX-License-Identifier: MIT
// The kernel for any IEEE 754 machine, fused multiply-add emulated where the compiler's target has none.
#include "network/kernel.hpp"

#define PANTIN_TARGET

namespace {
struct Vector {
    static constexpr int width = 4;
    float v[4];
    static Vector load(const float* p) { return {{p[0], p[1], p[2], p[3]}}; }
    static Vector broadcast(const float* p) { return {{*p, *p, *p, *p}}; }
    static Vector fma(const Vector& a, const Vector& b, const Vector& c) {
        Vector out;
        for (int i = 0; i < 4; ++i) out.v[i] = pantin::network::fused(a.v[i], b.v[i], c.v[i]);
        return out;
    }
    static Vector positive_part(const Vector& a) {
        Vector out;
        for (int i = 0; i < 4; ++i) out.v[i] = a.v[i] > 0 ? a.v[i] : 0.0f;
        return out;
    }
    void store(float* p) const {
        for (int i = 0; i < 4; ++i) p[i] = v[i];
    }
};
constexpr int group = 2;
} // namespace

#include "network/kernel_template.hpp"

const pantin::network::Kernel pantin::network::kernel_baseline = {Vector::width, run};
