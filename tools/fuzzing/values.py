# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What a number, a word or an expression is replaced by."""

import math
import re

NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")
#: Numbers that no one expects.
HOSTILE = (
    "0 -1 -0.0 1e308 -1e308 1e-308 5e-324 1e400 1e-400 nan inf -inf NaN Infinity 1e 1e+ .e3 - + . ,"
    " 2147483647 2147483648 -2147483649 4294967295 4294967296 9223372036854775808"
    " 18446744073709551616 99999999999999999999999 0x10 1d3 1,5 1;5 1/0 0/0 sqrt(-1) 1e5*t x y z t"
    " log(0) pi 1e16 1e-16 1e9 -1e9 1e-9 0.3333333333333333 1 2 3 10 true false none automatic"
).split()
#: Expressions, some of which are wrong at some times and places only.
EXPRESSIONS = (
    "if(t>0.03,1/0,0)",
    "if(t>0.03,1e300,0)",
    "sqrt(0.03-t)",
    "1/(x-0.5)",
    "exp(1000*t)",
    "sin(1e9*t)",
    "rand(1)",
    "rand_seed(0)",
    "if(x>0,1)",
    "if(,,)",
    "x=1",
    "a=3",
    "x,y",
    "sin",
    "sin()",
    "sin(x,y)",
    "min()",
    "_pi",
    "1e3*sin(50*t)",
    "x<y",
    "x?y:z",
    "t?1/0:0",
    '"text"',
    "abs(x)^0.5",
    "-100*x",
    "erf(x)+erfc(t)",
    "floor(x/0)",
    "int(1e300)",
    "x^1e5",
    "(-1)^0.5",
    "x!",
    "x&&y",
    "1||1/0",
    "-x^-y",
)
#: Characters that separate, open or begin something, and some that belong nowhere; the last one
#: stands for a byte that is no text.
SIGNS = "=#;,:|[](){}'\"\\/*-+^%$&!?<>~`@ \t\r\v\f\0\x7f\x1b\u00e9\u2028\udcff"


def number(source, old):
    """Another number: hostile, or not far from the old one."""
    if source.random() < 0.5:
        return source.choice(HOSTILE)
    try:
        value = float(old)
    except ValueError:
        return source.choice(HOSTILE)
    if re.fullmatch(r"[-+]?\d+", old) and abs(value) < 1e9:
        return str(int(value) + source.choice((-2, -1, 1, 2, 3)))
    factor = 10 ** source.choice((-12, -6, -3, -1, 1, 3, 6, 12))
    new = (value * factor, -value, value * 1.1, value + 1, value / 3, -value * factor)
    found = source.choice(new)
    return repr(found) if math.isfinite(found) else "1e308"


def long_text(source):
    """Much of the same, or deep."""
    n = source.choice((100, 3000, 100000, 1000000))
    kind = source.randrange(6)
    if kind == 0:
        return "(" * n + "1" + ")" * n
    if kind == 1:
        return "-" * n + "1"
    if kind == 2:
        return "+".join(["x"] * (n // 2))
    if kind == 3:
        return ", ".join(["1"] * (n // 3))
    if kind == 4:
        return "sin(" * (n // 4) + "x" + ")" * (n // 4)
    return source.choice("a1 ;|") * n


def value(source, words):
    """Anything for a key. words: values that are known."""
    kind = source.random()
    if kind < 0.35:
        return source.choice(HOSTILE)
    if kind < 0.5:
        return source.choice(EXPRESSIONS)
    if kind < 0.6:
        separator = source.choice((", ", "; ", " | ", " : "))
        pool = HOSTILE + list(EXPRESSIONS)
        return separator.join(source.choice(pool) for _ in range(source.randint(2, 4)))
    if kind < 0.9:
        return source.choice(words)
    if kind < 0.92:
        return long_text(source)
    return ""
