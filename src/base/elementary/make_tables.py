#!/usr/bin/env python3
"""The tables of the elementary functions, from integers of 320 bits: no floating point, no library of numbers.

usage: make_tables.py FOLDER     writes tables.h and table_*.c

Every number is made by a series that is written out below. A pair is the nearest double and the nearest double to what
that leaves, so it is right to 2^-106 of its first part.
"""
import sys

BITS = 320                      # after the point: the tables want 2^-140 at most, and 1/(2 pi) is made by itself
ONE = 1 << BITS


# ---- series, on integers that stand for n / 2^BITS ----

def arc_cotangent(n, one=ONE):
    """atan(1/n) for whole n > 1: 1/n - 1/(3 n^3) + 1/(5 n^5) - ..."""
    power = one // n
    total, k = power, 1
    while power:
        power //= n * n
        k += 2
        total += -(power // k) if k % 4 == 3 else power // k
    return total


def pi(one=ONE):
    """Machin: pi/4 = 4 atan(1/5) - atan(1/239)."""
    return 4 * (4 * arc_cotangent(5, one) - arc_cotangent(239, one))


def arc_tangent(top, bottom):
    """atan(top / bottom), 0 <= top <= bottom. Halved with tan(a/2) = t / (1 + sqrt(1 + t^2)) until the series is short."""
    t, doublings = ONE * top // bottom, 6
    for _ in range(doublings):
        t = (t << BITS) // (ONE + square_root(ONE + (t * t >> BITS)))
    power, total, k, square = t, t, 1, t * t >> BITS
    while power:
        power = power * square >> BITS
        k += 2
        total += -(power // k) if k % 4 == 3 else power // k
    return total << doublings


def square_root(x):
    import math
    return math.isqrt(x << BITS)


def sine(x):
    """sin x, |x| < 2: x - x^3/3! + ..."""
    power, total, k = x, x, 1
    while power:
        power = -(power * x >> BITS) * x >> BITS
        power //= (k + 1) * (k + 2)
        k += 2
        total += power
        if power == -1:
            break
    return total


def exponential(x):
    """e^x, 0 <= x < 1: the sum of x^k / k!."""
    power, total, k = ONE, ONE, 0
    while power:
        k += 1
        power = (power * x >> BITS) // k
        total += power
    return total


def logarithm(top, bottom):
    """log(top / bottom) by 2 artanh((t - b) / (t + b)) = 2 (z + z^3/3 + z^5/5 + ...)."""
    z = ((top - bottom) << BITS) // (top + bottom)
    power, total, k, square = z, z, 1, z * z >> BITS
    while abs(power) > 1:
        power = power * square >> BITS
        k += 2
        total += power // k
    return 2 * total


def cube_root(top, bottom):
    """The root of the whole number top / bottom * 2^(3 BITS), by Newton from above."""
    n = (top << 3 * BITS) // bottom
    x = 1 << (n.bit_length() // 3 + 1)
    while True:
        y = (2 * x + n // (x * x)) // 3
        if y >= x:
            return x
        x = y


# ---- doubles ----

def rounded(x, bits=53):
    """The nearest number of so many bits, halves to even."""
    size = abs(x).bit_length()
    if size <= bits:
        return x
    shift = size - bits
    whole, rest = abs(x) >> shift, abs(x) & ((1 << shift) - 1)
    half = 1 << (shift - 1)
    if rest > half or (rest == half and whole & 1):
        whole += 1
    return (whole << shift) * (1 if x > 0 else -1)


def cut(x, place):
    """x without what is below 2^-place."""
    return (x >> (BITS - place)) << (BITS - place)


def text(x):
    """A fixed point number of at most 53 bits as a hexadecimal literal."""
    if x == 0:
        return "0"
    return literal(abs(x), -BITS, x < 0)


def literal(n, exponent, negative=False):
    while n % 2 == 0:
        n //= 2
        exponent += 1
    lead = n.bit_length() - 1
    digits = (lead + 3) // 4
    n <<= 4 * digits - lead
    body = "%x" % n
    tail = ("." + body[1:]) if digits else ""
    return "%s0x%s%sp%d" % ("-" if negative else "", body[0], tail, exponent + lead)


def pair(x):
    high = rounded(x)
    return high, rounded(x - high)


def pair_text(x):
    return ", ".join(text(part) for part in pair(x))


# ---- the tables ----

def exponentials():
    """2^(j/128)."""
    two = logarithm(2, 1)
    return ["{" + pair_text(exponential(two * j // 128)) + "}" for j in range(128)]


def small_exponentials():
    """e^(j/128) for j = -88 .. 88: 26 bits and the rest."""
    rows = []
    for j in range(-88, 89):
        x = exponential(ONE * abs(j) // 128)
        x = (ONE << BITS) // x if j < 0 else x
        first = rounded(x, 26)
        rows.append("{%s, %s}" % (text(first), text(rounded(x - first))))
    return rows


def logarithms():
    """For m in [11/16, 11/8), in 128 parts by its bits: r, near 1/m, of eight bits after the point and of seven where
    m < 1, so that m r - 1 is a double; r a - 1 for the start a of the part; and -log r in a part that ends at 2^-42 and
    the rest, to the base e and to the base 2. In the parts that touch 1, r is 1 and the logarithm 0."""
    two, rows, binary = logarithm(2, 1), [], []
    for j in range(128):
        # The parts are equal in the bits of a double: half as wide below 1.
        low, high = ends_of_part(j)
        places = 128 if high <= 256 * 256 else 256
        if high == 256 * 256 or low == 256 * 256:
            r = places
        else:
            middle = low + high               # twice the middle, over 2^16
            r = (2 * places * 65536 * 2 + middle) // (2 * middle)
        x = -logarithm(r, places) if r != places else 0
        ends = [ONE * r * end // (places * 65536) - ONE for end in (low, high)]
        assert max(map(abs, ends)) <= ONE >> 7 and (x == 0 or max(map(abs, ends)) < abs(x))
        first = cut(x + (ONE >> 43), 42)
        rows.append("{%s, %s, %s, %s}" % (text(r * ONE // places), text(ends[0]), text(first), text(rounded(x - first))))
        x = (x << BITS) // two
        first = cut(x + (ONE >> 43), 42)
        binary.append("{%s, %s}" % (text(first), text(rounded(x - first))))
    return rows, binary


def ends_of_part(j):
    """Ends of part j, over 2^16."""
    at = 48 + j                               # 11/16 is 1.375 / 2: 48 of 128 parts of the octave from 1/2
    if at < 128:
        return (128 + at) * 256, (129 + at) * 256
    return (at) * 512, (at + 1) * 512


def sines():
    """sin(j pi/128) for j = 0 .. 319: a whole turn, and a quarter more for the cosine."""
    rows = []
    quarter = [0 if j == 0 else ONE if j == 64 else sine(pi() * j // 128) for j in range(65)]
    for j in range(320):
        k = j % 256
        sign = -1 if k > 128 else 1
        k = 256 - k if k > 128 else k
        rows.append("{" + pair_text(sign * quarter[128 - k if k > 64 else k]) + "}")
    return rows


def arc_tangents():
    """atan(j/128) for j = 0 .. 128."""
    return ["{" + pair_text(arc_tangent(j, 128)) + "}" for j in range(129)]


def tangents():
    """tan(j pi/128) for j = 0 .. 31 and then from -32 to -1: 26 bits and the rest."""
    rows = []
    for j in range(64):
        k = j if j < 32 else 64 - j
        x = ONE if k == 32 else (sine(pi() * k // 128) << BITS) // sine(pi() * (64 - k) // 128) if k else 0
        x = x if j < 32 else -x
        first = rounded(x, 26)
        rows.append("{%s, %s}" % (text(first), text(rounded(x - first))))
    return rows


def arc_sines():
    """asin(c + d) for c = j/256, j = 24 .. 128: asin(c) as a pair; the factors of d, less 1, of d^2 ... d^6; and that
    of d over 2 c. The derivative g obeys (1 - x^2) g' = x g, so (1 - c^2) (n + 1) g[n + 1] =
    c (2 n + 1) g[n] + n g[n - 1]."""
    rows = []
    for j in range(24, 129):
        c = ONE * j // 256
        rest = ONE - (c * c >> BITS)
        root = square_root(rest)
        g = [(ONE << BITS) // root]
        for n in range(5):
            before = n * g[n - 1] if n else 0
            g.append((((2 * n + 1) * c * g[n] >> BITS) + before << BITS) // ((n + 1) * rest))
        factors = [g[0] - ONE] + [x // (n + 1) for n, x in enumerate(g) if n] + [(g[0] << BITS) // (2 * c)]
        rows.append("{%s, %s}" % (pair_text(arc_tangent(c, root)), ", ".join(text(rounded(x)) for x in factors)))
    return rows


def cube_roots():
    """For the middle c of each 32nd of an octave, in the three octaves from 1: t near the cube root, of 17 bits, and
    1 / t^3."""
    rows = []
    for octave in range(3):
        for j in range(32):
            top, bottom = (65 + 2 * j) << octave, 64
            t = rounded(cube_root(top, bottom), 17)
            inverse = (ONE << 2 * BITS) // (t * t * t >> BITS)
            rows.append("{%s, %s}" % (text(t), text(rounded(inverse))))
    return rows


def turns():
    """1 / (2 pi) = 0.w0 w1 w2 ... in words of 32 bits: as many as the largest double asks for."""
    count = 40                                # 1024 bits before, 192 for the window, and a word
    bits = 32 * count + 64
    one = 1 << bits
    fraction = (one << bits) // (2 * pi(one << 64) >> 64)
    return ["0"] + ["0x%08x" % (fraction >> (bits - 32 * (k + 1)) & 0xffffffff) for k in range(count)]


# ---- constants of reductions ----

def constants():
    two, angle, whole = logarithm(2, 1), pi() // 128, 2 * pi()
    lines = []

    def define(name, x, comment):
        lines.append("/* %s */\n#define %s %s\n" % (comment, name, text(x)))

    step = two // 128
    first = cut(step, 42)
    define("BAT_EXP_STEP_1", first, "log(2) / 128, as far as 2^-42, so that its multiples are exact; and the rest.")
    define("BAT_EXP_STEP_2", rounded(step - first), "")
    define("BAT_EXP_STEPS", rounded((ONE << BITS) // step), "128 / log(2).")
    first = cut(two, 42)
    define("BAT_LOG_2_1", first, "log(2), as far as 2^-42, and the rest.")
    define("BAT_LOG_2_2", rounded(two - first), "")
    for name, base in (("BAT_LOG2_E", 2), ("BAT_LOG10_E", 10)):
        factor = (ONE << BITS) // logarithm(base, 1)
        first = rounded(factor, 26)
        define(name + "_1", first, "1 / log(%d), of 26 bits, and the rest." % base)
        define(name + "_2", rounded(factor - first), "")
    parts, rest = [], angle
    for place in (32, 59, 86):
        part = cut(rest, place)
        parts.append(part)
        rest -= part
    define("BAT_TURN_STEP_1", parts[0], "pi / 128 in three parts of 27 bits, whose multiples below 2^26 are exact, and the rest.")
    define("BAT_TURN_STEP_2", parts[1], "")
    define("BAT_TURN_STEP_3", parts[2], "")
    define("BAT_TURN_STEP_4", rounded(rest), "")
    define("BAT_TURN_STEPS", rounded((ONE << BITS) // angle), "128 / pi.")
    high, low = pair(whole)
    define("BAT_WHOLE_TURN_1", high, "2 pi, a pair.")
    define("BAT_WHOLE_TURN_2", low, "")
    high, low = pair(pi())
    define("BAT_PI_1", high, "pi, a pair.")
    define("BAT_PI_2", low, "")
    return "".join(line.replace("/*  */\n", "") for line in lines)


TABLES = (
    ("exp", "const double bat_exponentials[128][2]", exponentials, "2^(j / 128), a pair."),
    ("expm1", "const double bat_small_exponentials[177][2]", small_exponentials,
     "e^(j / 128) for j = -88 ... 88: 26 bits and the rest."),
    ("log", "const double bat_logarithms[128][4]", lambda: logarithms()[0],
     "1/c to some bits, a/c - 1 for the start a of the part, log(c): as far as 2^-42, and the rest."),
    ("log2", "const double bat_binary_logarithms[128][2]", lambda: logarithms()[1],
     "log2(c) for the same c: as far as 2^-42, and the rest."),
    ("sine", "const double bat_sines[320][2]", sines, "sin(j pi / 128), a pair."),
    ("tan", "const double bat_tangents[64][2]", tangents, "tan(j pi / 128) for j from 0 to 31 and from -32 to -1: 26 bits and the rest."),
    ("atan", "const double bat_arc_tangents[129][2]", arc_tangents, "atan(j / 128), a pair."),
    ("asin", "const double bat_arc_sines[105][9]", arc_sines,
     "asin(c + d) for c = j/256 from j = 24 on: asin(c), a pair, the factors of d, less 1, of d^2 ... d^6, and that of d over 2 c."),
    ("cbrt", "const double bat_cube_roots[96][2]", cube_roots, "t, near the cube root, of 17 bits; 1 / t^3."),
    ("turn", "const uint32_t bat_turns[41]", turns, "A word that is 0, and the bits of 1 / (2 pi) behind the point."),
)


def write(folder):
    made = "Made by make_tables.py, which says how; change that."
    with open(folder + "/tables.h", "w") as out:
        out.write("/* The tables and constants of the elementary functions. %s */\n" % made)
        out.write("#ifndef BAT_ELEMENTARY_TABLES_H\n#define BAT_ELEMENTARY_TABLES_H\n#include <stdint.h>\n\n")
        for _, name, _, comment in TABLES:
            out.write("/* %s */\nextern %s;\n" % (comment, name))
        out.write("\n" + constants() + "\n#endif\n")
    for file, name, rows, comment in TABLES:
        rows = rows()
        with open("%s/table_%s.c" % (folder, file), "w") as out:
            out.write("/* %s %s */\n#include \"base/elementary/tables.h\"\n\n/* clang-format off */\n" % (comment, made))
            out.write("%s = {\n" % name)
            wide = 5 if file == "turn" else 1
            for at in range(0, len(rows), wide):
                out.write("    %s,\n" % ", ".join(rows[at:at + wide]))
            out.write("};\n")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    write(sys.argv[1])
