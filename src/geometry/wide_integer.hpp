// SPDX-License-Identifier: MIT
// Integers of 128 bits for exact predicates: the compiler's own where it has them, else (processors of 32
// bits) the class below, which has the operators that the predicates use. Own.
#pragma once

#include <bit>
#include <cmath>
#include <compare>
#include <cstdint>

namespace pantin {

// Two's complement; overflow wraps.
class TwoWordInteger {
public:
    constexpr TwoWordInteger(std::int64_t value = 0)
        : low_(static_cast<std::uint64_t>(value)), high_(value < 0 ? ~std::uint64_t{0} : 0) {}

    friend constexpr TwoWordInteger operator-(TwoWordInteger a) { return TwoWordInteger() - a; }
    friend constexpr TwoWordInteger operator+(TwoWordInteger a, TwoWordInteger b) {
        const std::uint64_t low = a.low_ + b.low_;
        return {a.high_ + b.high_ + (low < a.low_), low};
    }
    friend constexpr TwoWordInteger operator-(TwoWordInteger a, TwoWordInteger b) {
        return {a.high_ - b.high_ - (a.low_ < b.low_), a.low_ - b.low_};
    }
    friend constexpr TwoWordInteger operator*(TwoWordInteger a, TwoWordInteger b) {
        TwoWordInteger product = words_product(a.low_, b.low_);
        product.high_ += a.high_ * b.low_ + a.low_ * b.high_;
        return product;
    }
    // Rounded towards 0, as of the compiler's integers; b ≠ 0.
    friend constexpr TwoWordInteger operator/(TwoWordInteger a, TwoWordInteger b) {
        const TwoWordInteger quotient = divided(a.magnitude(), b.magnitude());
        return a.is_negative() != b.is_negative() ? -quotient : quotient;
    }
    friend constexpr TwoWordInteger operator%(TwoWordInteger a, TwoWordInteger b) { return a - a / b * b; }
    constexpr TwoWordInteger& operator/=(TwoWordInteger b) { return *this = *this / b; }

    friend constexpr bool operator==(TwoWordInteger a, TwoWordInteger b) = default;
    friend constexpr std::strong_ordering operator<=>(TwoWordInteger a, TwoWordInteger b) {
        if (a.high_ != b.high_)
            return static_cast<std::int64_t>(a.high_) <=> static_cast<std::int64_t>(b.high_);
        return a.low_ <=> b.low_;
    }

    // The nearest double, ties to even.
    explicit operator double() const {
        const TwoWordInteger size = magnitude();
        const int drop = size.high_ == 0 ? 0 : 64 - std::countl_zero(size.high_);
        std::uint64_t leading = size.low_;
        if (drop > 0) {
            leading = drop == 64 ? size.high_ : size.high_ << (64 - drop) | size.low_ >> drop;
            const bool rest =
                drop == 64 ? size.low_ != 0 : (size.low_ & ((std::uint64_t{1} << drop) - 1)) != 0;
            leading |= rest; // far below the last bit that stays: decides between ties alone
        }
        const double value = std::ldexp(static_cast<double>(leading), drop);
        return is_negative() ? -value : value;
    }

private:
    constexpr TwoWordInteger(std::uint64_t high, std::uint64_t low) : low_(low), high_(high) {}
    constexpr bool is_negative() const { return high_ >> 63 != 0; }
    constexpr TwoWordInteger magnitude() const { return is_negative() ? -*this : *this; }
    constexpr bool bit(int i) const { return ((i < 64 ? low_ >> i : high_ >> (i - 64)) & 1) != 0; }

    static constexpr TwoWordInteger words_product(std::uint64_t a, std::uint64_t b) {
        const std::uint64_t half = 0xffffffff;
        const std::uint64_t low = (a & half) * (b & half), across = (a >> 32) * (b & half) + (low >> 32);
        const std::uint64_t other = (a & half) * (b >> 32) + (across & half);
        return {(a >> 32) * (b >> 32) + (across >> 32) + (other >> 32), other << 32 | (low & half)};
    }
    // Long division, bit by bit, of two that are not negative.
    static constexpr TwoWordInteger divided(TwoWordInteger a, TwoWordInteger b) {
        TwoWordInteger quotient, rest;
        for (int i = 126; i >= 0; --i) {
            rest = rest + rest + TwoWordInteger(a.bit(i));
            quotient = quotient + quotient;
            if (rest < b) continue;
            rest = rest - b;
            quotient = quotient + TwoWordInteger(1);
        }
        return quotient;
    }

    std::uint64_t low_, high_;
};

#ifdef __SIZEOF_INT128__
using WideInteger = __int128;
#else
using WideInteger = TwoWordInteger;
#endif

} // namespace pantin
