// What mutants.py writes into its copy of the formulas: every chosen operator and constant asks whether it is the one
// that is wrong in this run. KREDA_MUTANT=0, or unset: all are right.
//   a + b   becomes   a + mutant::Operator<7>{} + b     the precedence of + is kept; a + b, or in mutant 7 a - b
//   0.5f    becomes   mutant::constant(8, 0.5f)
// Nothing of this is ever part of a program.
#pragma once

#include <cstdlib>
#include <type_traits>

namespace mutant {

inline const int chosen = std::getenv("KREDA_MUTANT") ? std::atoi(std::getenv("KREDA_MUTANT")) : 0;

template <int Id>
struct Operator {};
template <int Id, class A>
struct Left {
    A a;
};

/// Half as much again; 0 becomes 1.
template <class Number>
inline Number constant(int id, Number value) {
    if (id != chosen) return value;
    return value == Number(0) ? Number(1) : value * Number(1.5);
}

/// Where the wrong operation does not exist for these types, or gives another type, the mutant is the program itself.
#define KREDA_MUTANT_OPERATOR(op, first, second)                               \
    template <int Id, class A>                                                 \
    inline Left<Id, A> operator op(const A& a, Operator<Id>) {                 \
        return {a};                                                            \
    }                                                                          \
    template <int Id, class A, class B>                                        \
    inline auto operator op(const Left<Id, A>& left, const B& b) {             \
        const A& a = left.a;                                                   \
        using Result = std::remove_cvref_t<decltype(a op b)>;                  \
        if (Id == chosen) {                                                    \
            if constexpr (requires { Result(first); }) return Result(first);   \
        }                                                                      \
        if (Id + 1 == chosen) {                                                \
            if constexpr (requires { Result(second); }) return Result(second); \
        }                                                                      \
        return Result(a op b);                                                 \
    }

KREDA_MUTANT_OPERATOR(+, a - b, b - a)
KREDA_MUTANT_OPERATOR(-, a + b, b - a)
KREDA_MUTANT_OPERATOR(*, a / b, b / a)
KREDA_MUTANT_OPERATOR(/, a* b, b / a)
KREDA_MUTANT_OPERATOR(<, b < a, true)
KREDA_MUTANT_OPERATOR(>, b > a, false)

#undef KREDA_MUTANT_OPERATOR

}  // namespace mutant
