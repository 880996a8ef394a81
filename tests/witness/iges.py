# The IGES files of this folder by the rules of IGES 5.3: records, the global section, directory entries, and of each
# entity the number and kinds of its parameters.
import glob, re, sys

# Types of entities, and the forms that are written of them.
FORMS = {102: [0], 106: [2], 110: [0], 116: [0], 124: [0, 1], 126: [0, 1], 128: [0], 142: [0], 144: [0], 186: [0], 308: [0], 314: [0],
         402: [7], 406: [1, 3, 15], 408: [0], 502: [1], 504: [1], 508: [1], 510: [1], 514: [1, 2]}
CURVES = (102, 106, 110, 126)
SURFACES = (128,)


def fields(line, count=10):
    return [line[8 * i:8 * i + 8] for i in range(count)]


def split(text):
    """The parameters of a record: strings are counted, as they may have the signs that part them."""
    found, at = [], 0
    while True:
        counted = re.compile(r" *(\d+)H").match(text, at)
        end = counted.end() + int(counted[1]) if counted else re.compile(r"[^,;]*").match(text, at).end()
        found.append(text[at:end].lstrip(" ")) # a line may be filled up before a parameter
        assert text[end] in ",;", "a string of another length: " + text[at:end]
        if text[end] == ";":
            assert not text[end + 1:].strip(), "text after the end"
            return found
        at = end + 1


class File:
    def __init__(self, data):
        lines = data.split("\n")
        assert lines.pop() == "" and all(len(l) == 80 for l in lines), "lines of 80"
        sections = "".join(l[72] for l in lines)
        assert re.fullmatch("S+G+D+P+T", sections), "order of sections"
        part = {c: [l for l in lines if l[72] == c] for c in "SGDPT"}
        for c, found in part.items():
            assert [int(l[73:]) for l in found] == list(range(1, len(found) + 1)), "numbers of section " + c
        assert part["T"][0][:32] == "S%7dG%7dD%7dP%7d" % tuple(len(part[c]) for c in "SGDP"), "the terminate section"
        self.check_global(split("".join(l[:72] for l in part["G"]).rstrip()))
        self.entries, self.matrices = {}, {}
        self.text = part["P"]
        first = 1
        for i in range(0, len(part["D"]), 2):
            first = self.add_entry(i + 1, fields(part["D"][i]), fields(part["D"][i + 1]), first)
        assert first == len(self.text) + 1, "parameter lines without an entry"

    def check_global(self, g):
        assert len(g) in (25, 26) and g[:2] == ["1H,", "1H;"], "the global section"
        units = {1: "IN", 2: "MM", 4: "FT", 6: "M", 10: "CM"}
        assert g[14] == "%dH%s" % (len(units[int(g[13])]), units[int(g[13])]), "the unit"
        self.resolution = float(g[18].replace("D", "E"))
        assert self.resolution > 0 and int(g[22]) == 11, "resolution and version"
        assert re.fullmatch(r"15H\d{8}\.\d{6}", g[17]) and re.fullmatch(r"15H\d{8}\.\d{6}", g[24]), "dates"

    def add_entry(self, number, one, two, first):
        """@return the line after its parameters"""
        kind, form, count = int(one[0]), int(two[4]), int(two[3])
        assert int(two[0]) == kind and int(one[1]) == first and count > 0, "D%d: its lines" % number
        assert form in FORMS[kind], "D%d: form %d of %d" % (number, form, kind)
        status = one[8]
        assert re.fullmatch(r"0[01]0[0-3]0[0-6]0[0-3]", status), "D%d: status %s" % (number, status)
        rows = self.text[first - 1:first - 1 + count]
        assert all(int(r[64:72]) == number for r in rows), "D%d: lines that point back" % number
        values = split("".join(r[:64] for r in rows).rstrip())
        assert int(values.pop(0)) == kind, "D%d: type of its parameters" % number
        self.entries[number] = (kind, form, status, int(two[2]), values)
        self.matrices[number] = int(one[6])
        return first + count

    def pointer(self, text, *kinds):
        assert int(text) > 0 and int(text) % 2 == 1 and self.entries[int(text)][0] in kinds, "pointer " + text
        return self.entries[int(text)]

    def check(self, number):
        kind, form, status, colour, values = self.entries[number]
        assert 0 <= colour <= 8 or self.pointer(str(-colour), 314), "colour"
        assert not self.matrices[number] or self.pointer(str(self.matrices[number]), 124), "matrix"
        rest = list(values)

        def take(pattern):
            """The next values, each as its letter says: integer, real, string."""
            found = rest[:len(pattern)]
            del rest[:len(pattern)]
            for value, letter in zip(found, pattern):
                form = {"i": r"-?\d+", "r": r"-?\d+\.\d*([ED][+-]?\d+)?", "s": r"(?s)(\d+H.*)?"}[letter]
                assert re.fullmatch(form, value), "%s is not %s" % (value, letter)
            assert len(found) == len(pattern), "too few parameters"
            return [int(v) if l == "i" else float(v.replace("D", "E")) if l == "r" else v for v, l in zip(found, pattern)]

        if kind in (126, 128):
            self.check_spline(kind, take)
        elif kind == 110:
            take("rrrrrr")
        elif kind == 116:
            assert take("rrri")[3] == 0, "no symbol"
        elif kind == 106:
            two, count = take("ii")
            assert two == 2
            take("rrr" * count)
        elif kind == 124:
            m = take("rrrrrrrrrrrr")
            x, y, z = (m[4 * i:4 * i + 3] for i in range(3))
            volume = (x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) +
                      x[2] * (y[0] * z[1] - y[1] * z[0]))
            assert abs(volume - (-1 if form else 1)) < 1e-9, "a matrix of the other form"
        elif kind == 308:
            depth, _, count = take("isi")
            for p in take("i" * count):
                member = self.pointer(str(p), *FORMS)
                assert member[2][2:4] == "01", "a member that stands alone"
                if member[0] == 408:
                    assert int(self.pointer(member[4][0], 308)[4][0]) < depth, "depth"
        elif kind == 408:
            self.pointer(str(take("irrrr")[0]), 308)
        elif kind == 314:
            assert all(0 <= c <= 100 for c in take("rrr")), "shares of a colour"
        elif kind == 102:
            for p in take("i" * take("i")[0]):
                assert self.pointer(str(p), *CURVES)[2][2:4] == "01", "a member that stands alone"
        elif kind == 142:
            _, surface, flat, curve, _ = take("iiiii")
            self.pointer(str(surface), *SURFACES)
            self.pointer(str(curve), *CURVES)
            if flat:
                assert self.pointer(str(flat), *CURVES)[2][4:6] == "05", "a parameter curve that does not say so"
        elif kind == 144:
            surface, is_bounded, count, outer = take("iiii")
            assert self.pointer(str(surface), *SURFACES) and is_bounded in (0, 1)
            for loop in ([outer] if is_bounded else []) + take("i" * count):
                assert self.pointer(str(loop), 142)[4][1] == str(surface), "a loop of another surface"
        elif kind == 502:
            take("rrr" * take("i")[0])
        elif kind == 504:
            for _ in range(take("i")[0]):
                curve, *ends = take("iiiii")
                assert self.pointer(str(curve), *CURVES)[2][2:4] == "01", "a curve that stands alone"
                for end, (a, i) in enumerate((ends[:2], ends[2:])):
                    miss = max(abs(p - q) for p, q in zip(self.end_of(curve, end), self.vertex(a, i)))
                    assert miss <= self.resolution, "an edge that misses its vertex by %g" % miss
        elif kind == 508:
            for _ in range(take("i")[0]):
                is_vertex, _, _, _, flat = take("iiiii")
                assert is_vertex in (0, 1)
                for _, curve in (take("ii") for _ in range(flat)):
                    assert self.pointer(str(curve), *CURVES)[2][4:6] == "05", "a parameter curve that does not say so"
            ends = [self.ends_of_use(use) for use in self.uses(number)]
            assert all(a[1] == b[0] for a, b in zip(ends, ends[1:] + ends[:1])), "uses that do not meet"
        elif kind == 510:
            surface, count, is_outer = take("iii")
            assert self.pointer(str(surface), *SURFACES) and is_outer in (0, 1)
            for loop in take("i" * count):
                self.pointer(str(loop), 508)
        elif kind == 514:
            ways = {}
            for face, agrees in (take("ii") for _ in range(take("i")[0])):
                for loop in self.pointer(str(face), 510)[4][3:3 + int(self.entries[face][4][1])]:
                    for is_vertex, edges, edge, along in self.uses(int(loop)):
                        if not is_vertex:
                            ways.setdefault((edges, edge), []).append(along == agrees)
            assert form == 2 or all(sorted(w) == [False, True] for w in ways.values()), "a shell that does not close"
        elif kind == 186:
            shell, agrees, count = take("iii")
            for shell, agrees in [(shell, agrees)] + [take("ii") for _ in range(count)]:
                assert self.pointer(str(shell), 514)[1] == 1 and agrees in (0, 1), "an open shell"
        elif kind == 402:
            for p in take("i" * take("i")[0]):
                self.pointer(str(p), *FORMS)
        elif kind == 406:
            take("i" + {1: "i", 3: "is", 15: "s"}[form] if form != 1 else "i" * (1 + int(rest[0])))
        # Then come lists of associativities and of properties.
        for wanted in ((402,), (406,)):
            for p in take("i" * take("i")[0]) if rest else []:
                self.pointer(str(p), *wanted)
        assert not rest, "more parameters than it has"

    def end_of(self, curve, end):
        """The first or last point of a line, or of a clamped spline."""
        kind, _, _, _, v = self.entries[curve]
        if kind == 110:
            return [float(x) for x in v[3 * end:3 * end + 3]]
        n, degree = int(v[0]), int(v[1])
        at = 6 + (n + degree + 2) + (n + 1) + 3 * n * end
        return [float(x.replace("D", "E")) for x in v[at:at + 3]]

    def vertex(self, list_, i):
        v = self.pointer(str(list_), 502)[4]
        assert 1 <= i <= int(v[0]), "no vertex of that number"
        return [float(x.replace("D", "E")) for x in v[3 * i - 2:3 * i + 1]]

    def uses(self, loop):
        """(is it a vertex, list, number, along) of each use of a loop."""
        v, at = self.pointer(str(loop), 508)[4], 1
        for _ in range(int(v[0])):
            yield tuple(int(x) for x in v[at:at + 4])
            at += 5 + 2 * int(v[at + 4])

    def ends_of_use(self, use):
        is_vertex, list_, number, along = use
        if is_vertex:
            return (self.vertex(list_, number),) * 2
        edge = self.pointer(str(list_), 504)[4][5 * number - 4:5 * number + 1]
        ends = [self.vertex(int(edge[1]), int(edge[2])), self.vertex(int(edge[3]), int(edge[4]))]
        return tuple(ends if along else ends[::-1])

    @staticmethod
    def check_spline(kind, take):
        sides = 1 if kind == 126 else 2
        highest = take("i" * sides)
        degrees = take("i" * sides)
        is_polynomial = take("iiii" if sides == 1 else "iiiii")[2]
        count = 1
        for n, degree in zip(highest, degrees):
            knots = take("r" * (n + degree + 2))
            assert all(a <= b for a, b in zip(knots, knots[1:])), "the order of knots"
            count *= n + 1
        weights = take("r" * count)
        assert min(weights) > 0 and (not is_polynomial or min(weights) == max(weights)), "weights"
        take("rrr" * count)
        ranges = take("rr" * sides)
        assert all(a < b for a, b in zip(ranges[::2], ranges[1::2])), "the range"
        if sides == 1:
            take("rrr")


failures = count = 0
for name in sys.argv[1:] or sorted(glob.glob("*.igs")):
    number = 0
    try:
        file = File(open(name, encoding="latin-1", newline="").read())
        for number in file.entries:
            file.check(number)
        print("iges: %s %d entities, %d kinds" % (name, len(file.entries), len({e[:2] for e in file.entries.values()})))
    except (AssertionError, KeyError, IndexError, ValueError) as error:
        failures += 1
        print("iges: %s D%d: %s: %s  FAILED" % (name, number, type(error).__name__, error))
    count += 1
print("WITNESS %d files, %d failed" % (count, failures))
sys.exit(failures > 0 or count == 0)
