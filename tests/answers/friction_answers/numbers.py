"""Elementary functions of the numbers in use: double precision, or 30 digits."""

import math

_now = math


def real(text):
    return float(text) if _now is math else _now.mpf(text)


def use_digits(digits):
    """Takes mpmath with these digits from here on, or doubles with None."""
    global _now
    if digits is None:
        _now = math
        return
    import mpmath

    mpmath.mp.dps = digits
    _now = mpmath.mp


def are_doubles():
    return _now is math


def sqrt(x):
    return _now.sqrt(x)


def sin(x):
    return _now.sin(x)


def cos(x):
    return _now.cos(x)


def atan(x):
    return _now.atan(x)


def asinh(x):
    return _now.asinh(x)


def asin(x):
    return _now.asin(x)


def text(x, digits):
    """Significant digits."""
    if _now is math:
        return f"{x:.{digits - 1}e}"
    return _now.nstr(x, digits, min_fixed=0, max_fixed=0, strip_zeros=False)
