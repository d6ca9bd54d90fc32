// What C++20's library has and emscripten 3.1 (libc++ 13) lacks, as far as Kreda uses it. tools/view/web.cmake puts it
// before every source of the module; with a newer library it holds nothing.
#pragma once

#include <version>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 15000

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>

namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
    return __builtin_bit_cast(To, from);
}

struct web_identity {
    template <class T>
    constexpr T&& operator()(T&& value) const noexcept {
        return static_cast<T&&>(value);
    }
};

/// Always the strictest order; with one thread plain loads and stores are made of it.
template <class T>
class atomic_ref {
public:
    explicit atomic_ref(T& value) : value_(value) {}
    T load(memory_order = memory_order_seq_cst) const {
        T loaded;
        __atomic_load(&value_, &loaded, __ATOMIC_SEQ_CST);
        return loaded;
    }
    void store(T value, memory_order = memory_order_seq_cst) const {
        __atomic_store(&value_, &value, __ATOMIC_SEQ_CST);
    }
    T exchange(T value, memory_order = memory_order_seq_cst) const {
        T before;
        __atomic_exchange(&value_, &value, &before, __ATOMIC_SEQ_CST);
        return before;
    }

private:
    T& value_;
};

namespace ranges {

template <class Range, class Condition, class Part = web_identity>
constexpr auto find_if(Range&& range, Condition condition, Part part = {}) {
    auto it = std::begin(range);
    while (it != std::end(range) && !std::invoke(condition, std::invoke(part, *it))) ++it;
    return it;
}

template <class Range, class Value, class Part = web_identity>
constexpr auto find(Range&& range, const Value& value, Part part = {}) {
    return ranges::find_if(
        range, [&](const auto& item) { return item == value; }, part);
}

template <class Range, class Condition>
constexpr bool any_of(Range&& range, Condition condition) {
    return ranges::find_if(range, condition) != std::end(range);
}

template <class Range, class Value>
constexpr auto count(Range&& range, const Value& value) {
    return std::count(std::begin(range), std::end(range), value);
}

template <class Range, class Output, class Change>
constexpr void transform(Range&& range, Output output, Change change) {
    for (auto&& item : range) *output++ = std::invoke(change, item);
}

template <class Range, class Less = std::less<>, class Part = web_identity>
void sort(Range&& range, Less less = {}, Part part = {}) {
    std::sort(std::begin(range), std::end(range),
              [&](const auto& a, const auto& b) { return less(std::invoke(part, a), std::invoke(part, b)); });
}

template <class Range, class Value>
bool binary_search(const Range& range, const Value& value) {
    return std::binary_search(std::begin(range), std::end(range), value);
}

}  // namespace ranges

/// As the standard has it for chars_format::general: no white space, no plus, no hexadecimal digits.
template <class Number, class = enable_if_t<is_floating_point_v<Number>>>
from_chars_result from_chars(const char* first, const char* last, Number& value) {
    const auto starts = [&](const char* p) { return p != last && ((*p >= '0' && *p <= '9') || *p == '.'); };
    const char* const digits = first != last && *first == '-' ? first + 1 : first;
    const bool is_word = digits != last && (*digits == 'i' || *digits == 'I' || *digits == 'n' || *digits == 'N');
    if (!starts(digits) && !is_word) return {first, errc::invalid_argument};
    const bool is_hexadecimal = last - digits > 1 && digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'X');
    const std::string text(first, is_hexadecimal ? digits + 1 : last);
    char* end = nullptr;
    errno = 0;
    const Number read = sizeof(Number) == sizeof(float) ? static_cast<Number>(strtof(text.c_str(), &end))
                                                        : static_cast<Number>(strtod(text.c_str(), &end));
    if (end == text.c_str()) return {first, errc::invalid_argument};
    const char* const stop = first + (end - text.c_str());
    if (errno == ERANGE && (read == 0 || isinf(read))) return {stop, errc::result_out_of_range};
    value = read;
    return {stop, errc{}};
}

}  // namespace std

#endif
