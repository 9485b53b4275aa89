#pragma once

namespace somato {

// Elementary functions with the same bits on every machine: the mathematics library's own differ
// between versions and processors. Only exact operations and explicit fused multiply-adds are used.

/// e^x in double precision, within 2 units in the last place; 0 below -745.14, infinity above
/// 709.79, NaN for NaN.
double exponential(double x);

/// The natural logarithm in double precision, within 2 units in the last place; -infinity for 0,
/// NaN below 0 or for NaN.
double natural_log(double x);

/// base^exponent for base >= 0, as exponential(exponent * natural_log(base)), so the relative error
/// grows with |exponent * log(base)|; power(0, e) is 0 for e > 0 and 1 for e = 0. NaN for a
/// negative base.
double power(double base, double exponent);

/// The cosine of a number of turns, cos(2 pi turns), with an absolute error below 2^-52; exact at
/// every quarter of a turn. NaN for NaN and infinities.
double cosine_of_turns(double turns);

}  // namespace somato
