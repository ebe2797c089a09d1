// SPDX-License-Identifier: MIT
// This work is based on:
// Sun Microsystems, FDLIBM 5.3, 1993 (argument reductions and minimax coefficients of exp, log, sin, cos,
// atan); T. J. Dekker, A floating-point technique for extending the available precision, 1971 (the pairs in
// `pow`).
#include "core/math.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pantin::math {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double ln2_high = 6.93147180369123816490e-01, ln2_low = 1.90821492927058770002e-10;

// 2^n for a normal result.
double power_of_two(int n) { return std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52); }

// x · 2^n, rounded once even where the result is subnormal (x is near 1).
double scaled(double x, int n) {
    if (n > 1000) return x * power_of_two(1000) * power_of_two(n - 1000);
    if (n < -1000) return x * power_of_two(n + 1000) * power_of_two(-1000);
    return x * power_of_two(n);
}

// x = m · 2^e with m in [√½, √2); x positive and finite.
double mantissa(double x, int& exponent) {
    int shift = 0;
    if (x < power_of_two(-1022)) {
        x *= power_of_two(54);
        shift = -54;
    }
    const auto bits = std::bit_cast<std::uint64_t>(x);
    exponent = static_cast<int>(bits >> 52) - 1023 + shift;
    double m = std::bit_cast<double>((bits & 0x000FFFFFFFFFFFFFu) | 0x3FF0000000000000u);
    if (m >= 1.41421356237309504880) {
        m *= 0.5;
        ++exponent;
    }
    return m;
}

// exp(x + tail) for a tail far smaller than x.
double exp_of(double x, double tail) {
    if (x != x) return x;
    if (x > 709.782712893383973096) return infinity;
    if (x < -745.13321910194110842) return 0;
    const double k = std::rint(x * 1.44269504088896338700);
    const double high = x - k * ln2_high, low = k * ln2_low - tail;
    const double r = high - low, t = r * r;
    const double c = r - t * (1.66666666666666019037e-01 +
                              t * (-2.77777777770155933842e-03 +
                                   t * (6.61375632143793436117e-05 +
                                        t * (-1.65339022054652515390e-06 + t * 4.13813679705723846039e-08))));
    return scaled(1.0 - ((low - (r * c) / (2.0 - c)) - high), static_cast<int>(k));
}

// sin and cos of x + y for |x| ≤ π/4, y the rounding error of the reduction.
double sin_kernel(double x, double y) {
    const double z = x * x, v = z * x;
    const double r = 8.33333333332248946124e-03 +
                     z * (-1.98412698298579493134e-04 +
                          z * (2.75573137070700676789e-06 +
                               z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)));
    return x - ((z * (0.5 * y - v * r) - y) - v * -1.66666666666666324348e-01);
}

double cos_kernel(double x, double y) {
    const double z = x * x;
    const double r =
        z * (4.16666666666666019037e-02 +
             z * (-1.38888888888741095749e-03 +
                  z * (2.48015872894767294178e-05 +
                       z * (-2.75573143513906633035e-07 +
                            z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)))));
    const double half = 0.5 * z, w = 1.0 - half;
    return w + (((1.0 - w) - half) + (z * r - x * y));
}

// Reduces x to [−π/4, π/4] (Cody & Waite with three parts of π/2); returns the quadrant 0…3.
int reduce(double x, double& r, double& tail) {
    const double n = std::rint(x * 6.36619772367581382433e-01);
    const double a = std::fma(-n, 1.57079632673412561417e+00, x); // exact: the parts of π/2 have 33 bits
    const double w = n * 6.07710050630396597660e-11;
    const double b = a - w, error_b = (a - b) - w;
    const double v = n * 2.02226624879595063154e-21;
    r = b - (v - error_b);
    tail = (b - r) - (v - error_b);
    return static_cast<int>(static_cast<std::int64_t>(n) & 3);
}

// arctan for x ≥ 0.
double atan_positive(double x) {
    constexpr double high[4] = {4.63647609000806093515e-01, 7.85398163397448278999e-01,
                                9.82793723247329054082e-01, 1.57079632679489655800e+00};
    constexpr double low[4] = {2.26987774529616870924e-17, 3.06161699786838301793e-17,
                               1.39033110312309984516e-17, 6.12323399573676603587e-17};
    if (x > power_of_two(66)) return high[3];
    int id = -1;
    if (x >= 2.4375) {
        id = 3, x = -1.0 / x;
    } else if (x >= 1.1875) {
        id = 2, x = (x - 1.5) / (1.0 + 1.5 * x);
    } else if (x >= 0.6875) {
        id = 1, x = (x - 1.0) / (x + 1.0);
    } else if (x >= 0.4375) {
        id = 0, x = (2.0 * x - 1.0) / (2.0 + x);
    }
    const double z = x * x, w = z * z;
    const double even =
        z * (3.33333333333329318027e-01 +
             w * (1.42857142725034663711e-01 +
                  w * (9.09088713343650656196e-02 +
                       w * (6.66107313738753120669e-02 +
                            w * (4.97687799461593236017e-02 + w * 1.62858201153657823623e-02)))));
    const double odd = w * (-1.99999999998764832476e-01 +
                            w * (-1.11111104054623557880e-01 +
                                 w * (-7.69187620504482999495e-02 +
                                      w * (-5.83357013379057348645e-02 + w * -3.65315727442169155270e-02))));
    if (id < 0) return x - x * (even + odd);
    return high[id] - ((x * (even + odd) - low[id]) - x);
}

// --- pairs: an unevaluated sum of two doubles, about 106 bits
// ------------------------------------------------

struct Pair {
    double high, low;
};
Pair quick_sum(double a, double b) { // |a| ≥ |b|
    const double s = a + b;
    return {s, b - (s - a)};
}
Pair sum(double a, double b) {
    const double s = a + b, t = s - a;
    return {s, (a - (s - t)) + (b - t)};
}
Pair add(Pair a, Pair b) {
    const Pair s = sum(a.high, b.high);
    return quick_sum(s.high, s.low + (a.low + b.low));
}
Pair multiply(Pair a, Pair b) {
    const double p = a.high * b.high;
    return quick_sum(p, std::fma(a.high, b.high, -p) + (a.high * b.low + a.low * b.high));
}
Pair divide(Pair a, Pair b) {
    const double q = a.high / b.high;
    const double rest = std::fma(-q, b.high, a.high) + (a.low - q * b.low);
    return quick_sum(q, rest / b.high);
}

// log x = e·ln 2 + 2·artanh((m − 1)/(m + 1)), |(m − 1)/(m + 1)| ≤ 0.172, to about 100 bits.
Pair log_pair(double x) {
    int exponent = 0;
    const double m = mantissa(x, exponent);
    const Pair s = divide({m - 1.0, 0}, sum(m, 1.0)), z = multiply(s, s);
    Pair series{0, 0};
    for (int n = 41; n >= 1; n -= 2)
        series = add(multiply(series, z), divide({1, 0}, {static_cast<double>(n), 0}));
    const Pair tail = multiply({2.0 * s.high, 2.0 * s.low}, series);
    const Pair ln2{6.931471805599452862e-01, 2.319046813846299558e-17};
    return add(multiply({static_cast<double>(exponent), 0}, ln2), tail);
}

bool is_whole(double x) { return std::rint(x) == x; }
bool is_odd(double x) {
    return is_whole(x) && std::fabs(x) < power_of_two(53) && (static_cast<std::int64_t>(x) & 1) != 0;
}

// pow where x or y is 0 or infinite and the general formula does not apply; x ≥ 0 here, y ≠ 0, x ≠ 1.
double special_pow(double x, double y) {
    if (std::fabs(y) == infinity) return (x > 1) == (y > 0) ? infinity : 0;
    return (x == 0) == (y > 0) ? 0 : infinity;
}

} // namespace

double exp(double x) { return exp_of(x, 0); }

double log(double x) {
    if (x != x || x < 0) return not_a_number;
    if (x == 0) return -infinity;
    if (x == infinity) return x;
    int exponent = 0;
    const double f = mantissa(x, exponent) - 1.0, k = exponent;
    const double s = f / (2.0 + f), z = s * s, w = z * z;
    const double t1 =
        w * (3.999999999940941908e-01 + w * (2.222219843214978396e-01 + w * 1.531383769920937332e-01));
    const double t2 =
        z * (6.666666666666735130e-01 +
             w * (2.857142874366239149e-01 + w * (1.818357216161805012e-01 + w * 1.479819860511658591e-01)));
    const double half = 0.5 * f * f;
    return k * ln2_high - ((half - (s * (half + (t1 + t2)) + k * ln2_low)) - f);
}

double sin(double x) {
    if (!(std::fabs(x) < power_of_two(52))) return not_a_number;
    if (std::fabs(x) < power_of_two(-27)) return x;
    double r = x, tail = 0;
    const int quadrant = reduce(x, r, tail);
    const double value = (quadrant & 1) ? cos_kernel(r, tail) : sin_kernel(r, tail);
    return (quadrant & 2) ? -value : value;
}

double cos(double x) {
    if (!(std::fabs(x) < power_of_two(52))) return not_a_number;
    double r = x, tail = 0;
    const int quadrant = reduce(x, r, tail);
    const double value = (quadrant & 1) ? sin_kernel(r, tail) : cos_kernel(r, tail);
    return quadrant == 1 || quadrant == 2 ? -value : value;
}

double atan2(double y, double x) {
    if (x != x || y != y) return not_a_number;
    const double ax = std::fabs(x), ay = std::fabs(y);
    double angle = 0; // of (|x|, |y|)
    if (ay == 0)
        angle = 0;
    else if (ax == 0 || (ay == infinity && ax != infinity))
        angle = pi / 2;
    else if (ax == infinity)
        angle = ay == infinity ? pi / 4 : 0;
    else
        angle = atan_positive(ay / ax);
    constexpr double pi_low = 1.2246467991473531772e-16;
    if (std::signbit(x)) angle = pi - (angle - pi_low);
    return std::copysign(angle, y);
}

double pow(double x, double y) {
    if (y == 0 || x == 1) return 1;
    if (x != x || y != y) return not_a_number;
    if (x == -1 && std::fabs(y) == infinity) return 1;
    const bool negative = std::signbit(x) && is_odd(y);
    if (x < 0 && x != -infinity && std::fabs(y) != infinity && !is_whole(y)) return not_a_number;
    const double ax = std::fabs(x);
    double value = 0;
    if (ax == 0 || ax == infinity || std::fabs(y) == infinity) {
        value = special_pow(ax, y);
    } else {
        // A y beyond 2^64 over- or underflows for every x ≠ ±1; cut there, so that the product stays finite.
        const double limit = power_of_two(64), bounded = y > limit ? limit : (y < -limit ? -limit : y);
        const Pair product = multiply(log_pair(ax), {bounded, 0});
        value = exp_of(product.high, product.low);
    }
    return negative ? -value : value;
}

} // namespace pantin::math
