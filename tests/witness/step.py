# The STEP files of this folder by the rules of ISO 10303-21, and of the entities of ISO 10303-41 to 46, 203, 214 and 242
# that are in them. Of each entity the table below has its supertypes and its own attributes:
#   string real integer boolean     values                  .a.b.      one of these words
#   name, name/name                 a reference to these    TYPE(kind) a value that states its type
#   kind[2]                         a list of 2 or more     ?kind      may be left out
import glob, re, sys

TABLE = """
application_context: string
application_protocol_definition: string string integer application_context
application_context_element: string application_context
product_context < application_context_element: string
mechanical_context < product_context:
product_definition_context < application_context_element: string
design_context < product_definition_context:
product: string string ?string product_context[1]
product_category: string ?string
product_related_product_category < product_category: product[1]
product_category_relationship: string string product_category product_category
product_definition_formation: string ?string product
product_definition_formation_with_specified_source < product_definition_formation: .made.bought.not_known.
product_definition: string ?string product_definition_formation product_definition_context
product_definition_relationship: string string ?string product_definition product_definition
assembly_component_usage < product_definition_relationship: ?string
next_assembly_usage_occurrence < assembly_component_usage:
property_definition: string ?string product_definition/product_definition_relationship
product_definition_shape < property_definition:
property_definition_representation: property_definition representation
shape_definition_representation < property_definition_representation:
representation: string representation_item[1] representation_context
shape_representation < representation:
advanced_brep_shape_representation < shape_representation:
manifold_surface_shape_representation < shape_representation:
geometrically_bounded_wireframe_shape_representation < shape_representation:
tessellated_shape_representation < shape_representation:
definitional_representation < representation:
mechanical_design_geometric_presentation_representation < representation:
representation_context: string string
geometric_representation_context < representation_context: integer
global_unit_assigned_context < representation_context: named_unit[1]
global_uncertainty_assigned_context < representation_context: uncertainty_measure_with_unit[1]
parametric_representation_context < representation_context:
representation_relationship: string ?string representation representation
representation_relationship_with_transformation < representation_relationship: item_defined_transformation
shape_representation_relationship < representation_relationship:
item_defined_transformation: string ?string representation_item representation_item
context_dependent_shape_representation: shape_representation_relationship product_definition_shape
named_unit: ?dimensional_exponents
length_unit < named_unit:
plane_angle_unit < named_unit:
solid_angle_unit < named_unit:
si_unit < named_unit: ?.milli.centi.deci.kilo.micro. .metre.radian.steradian.
conversion_based_unit < named_unit: string measure_with_unit
dimensional_exponents: real real real real real real real
measure_with_unit: LENGTH_MEASURE(real) named_unit
length_measure_with_unit < measure_with_unit:
uncertainty_measure_with_unit < measure_with_unit: string ?string
representation_item: string
geometric_representation_item < representation_item:
topological_representation_item < representation_item:
point < geometric_representation_item:
cartesian_point < point: real[2]
direction < geometric_representation_item: real[2]
axis2_placement_3d < geometric_representation_item: cartesian_point ?direction ?direction
curve < geometric_representation_item:
bounded_curve < curve:
b_spline_curve < bounded_curve: integer cartesian_point[2] .unspecified. boolean boolean
b_spline_curve_with_knots < b_spline_curve: integer[2] real[2] .unspecified.
rational_b_spline_curve < b_spline_curve: real[2]
pcurve < curve: surface definitional_representation
surface_curve < curve: curve pcurve[1] .curve_3d.
seam_curve < surface_curve:
surface < geometric_representation_item:
bounded_surface < surface:
b_spline_surface < bounded_surface: integer integer cartesian_point[2][2] .unspecified. boolean boolean boolean
b_spline_surface_with_knots < b_spline_surface: integer[2] integer[2] real[2] real[2] .unspecified.
rational_b_spline_surface < b_spline_surface: real[2][2]
vertex < topological_representation_item:
vertex_point < vertex: point
edge < topological_representation_item: vertex vertex
edge_curve < edge: curve boolean
oriented_edge < topological_representation_item: * * edge boolean
loop < topological_representation_item:
vertex_loop < loop: vertex
edge_loop < loop: oriented_edge[1]
face_bound < topological_representation_item: loop boolean
face_outer_bound < face_bound:
face < topological_representation_item: face_bound[1]
advanced_face < face: surface boolean
connected_face_set < topological_representation_item: face[1]
open_shell < connected_face_set:
closed_shell < connected_face_set:
oriented_closed_shell < topological_representation_item: * closed_shell boolean
shell_based_surface_model < geometric_representation_item: open_shell/closed_shell[1]
manifold_solid_brep < geometric_representation_item: closed_shell
brep_with_voids < manifold_solid_brep: oriented_closed_shell[1]
geometric_curve_set < geometric_representation_item: point/curve[1]
tessellated_item < geometric_representation_item:
coordinates_list < tessellated_item: integer real[3][1]
triangulated_face < tessellated_item: coordinates_list integer real[3][0] ?face/surface integer[0] integer[3][1]
tessellated_shell < tessellated_item: triangulated_face[1] ?connected_face_set
styled_item < representation_item: presentation_style_assignment[1] representation_item
presentation_style_assignment: surface_style_usage/curve_style/point_style/NULL_STYLE(.null.)[1]
surface_style_usage: .positive.negative.both. surface_side_style
surface_side_style: string surface_style_fill_area[1]
surface_style_fill_area: fill_area_style
fill_area_style: string fill_area_style_colour[1]
fill_area_style_colour: string colour_rgb
colour_rgb: string real real real
curve_style: string draughting_pre_defined_curve_font POSITIVE_LENGTH_MEASURE(real) colour_rgb
draughting_pre_defined_curve_font: string
point_style: string MARKER_TYPE(.dot.x.plus.asterisk.ring.square.triangle.) POSITIVE_LENGTH_MEASURE(real) colour_rgb
presentation_layer_assignment: string string representation_item[1]
invisibility: styled_item[1]
group: string ?string
group_relationship: string ?string group group
applied_group_assignment: group representation_item[1]
person: string ?string ?string ?string[1] ?string[1] ?string[1]
organization: ?string string ?string
person_and_organization: person organization
person_and_organization_role: string
cc_design_person_and_organization_assignment: person_and_organization person_and_organization_role *[1]
calendar_date: integer integer integer
coordinated_universal_time_offset: integer ?integer .ahead.behind.
local_time: integer ?integer ?real coordinated_universal_time_offset
date_and_time: calendar_date local_time
date_time_role: string
cc_design_date_and_time_assignment: date_and_time date_time_role *[1]
security_classification_level: string
security_classification: string string security_classification_level
cc_design_security_classification: security_classification *[1]
approval_status: string
approval: approval_status string
approval_role: string
approval_person_organization: person_and_organization approval approval_role
approval_date_time: date_and_time approval
cc_design_approval: approval *[1]
"""
# The first schema of AP203 has no colours, layers, groups; tessellations came with AP242.
NOT_IN_203 = re.compile("style|colour|draughting|(^|_)presentation|invisib|group|tessellated|triangulated|coordinates_list")
NOT_IN_214 = re.compile("tessellated|triangulated|coordinates_list")

PARENT, OWN = {}, {}
for line in TABLE.strip().split("\n"):
    head, own = line.split(":")
    name, _, PARENT[head.split(" < ")[0]] = head.partition(" < ")
    OWN[name] = own.split()


def lineage(name):
    """The entity and its supertypes, highest first."""
    return (lineage(PARENT[name]) if PARENT[name] else []) + [name]


TOKEN = re.compile(r"\s*(?:(?P<reference>#\d+)|(?P<real>[+-]?\d+\.\d*(?:E[+-]?\d+)?)|(?P<integer>[+-]?\d+)"
                   r"|(?P<word>\.[A-Z0-9_]+\.)|(?P<type>[A-Z][A-Z0-9_]*)|(?P<sign>[(),=;$*])"
                   r"|'(?P<string>(?:[^'\\]|''|\\\\|\\S\\.|\\X\\[0-9A-F]{2}|\\X2\\(?:[0-9A-F]{4})+\\X0\\"
                   r"|\\X4\\(?:[0-9A-F]{8})+\\X0\\)*)')")


class File:
    """The instances: reference to its parts, a list of an entity and its values. A value is its kind and its content."""

    def __init__(self, text):
        end = "ENDSEC;\nEND-ISO-10303-21;\n"
        assert text.startswith("ISO-10303-21;\nHEADER;\n") and text.endswith(end), "its frame"
        assert text.isascii() and max(map(len, text.split("\n"))) <= 255, "characters or lines"
        head, data = text[:-len(end)].split("ENDSEC;\nDATA;\n")
        self.schema = re.search(r"FILE_SCHEMA\(\('(\w+)", head)[1]
        data = data.rstrip()
        self.tokens, at = [], 0
        while at < len(data):
            found = TOKEN.match(data, at)
            assert found, "no token: " + data[at:at + 40]
            self.tokens.append((found.lastgroup, found[found.lastgroup]))
            at = found.end()
        self.tokens.reverse()
        self.parts = {}
        while self.tokens:
            self.read_instance()
        self.values = {reference: self.attributes(reference) for reference in self.parts}

    def take(self, wanted=None):
        found = self.tokens.pop()[1]
        assert wanted in (None, found), "%s where %s should be" % (found, wanted)
        return found

    def next_is(self, text):
        return self.tokens[-1] == ("sign", text)

    def read_instance(self):
        reference = self.take()
        assert reference not in self.parts, reference + " twice"
        self.take("=")
        parts = []
        if self.next_is("("):
            self.take()
            while not self.next_is(")"):
                parts.append((self.take().lower(), self.read_list()))
            self.take()
            names = [p[0].upper() for p in parts]
            assert names == sorted(names), reference + ": order of its parts"
        else:
            parts.append((self.take().lower(), self.read_list()))
        self.take(";")
        self.parts[reference] = parts

    def read_list(self):
        found = []
        self.take("(")
        while not self.next_is(")"):
            if found:
                self.take(",")
            kind, text = self.tokens[-1]
            if self.next_is("("):
                found.append(("list", self.read_list()))
            else:
                self.take()
                found.append((text, self.read_list()[0]) if kind == "type" else (kind, text))
        self.take()
        return found

    def is_of(self, reference, *names):
        return any(n == "*" or n in lineage(part) for part, _ in self.parts[reference] for n in names)

    def fits(self, value, kind):
        """Is the value of that kind?"""
        form, content = value
        if content == "*" and kind[0] in "?*" or content == "$" and kind[0] == "?":
            return True
        kind = kind.lstrip("?")
        if kind.endswith("]"):
            kind, least = kind[:-1].rsplit("[", 1)
            return form == "list" and len(content) >= int(least) and all(self.fits(v, kind) for v in content)
        if form == "reference":
            return content in self.parts and self.is_of(content, *kind.split("/"))
        if form == "word":
            return content.lower() in (".t.f." if kind == "boolean" else kind)
        if form in ("string", "real", "integer"):
            return form == kind
        return any(k.startswith(form + "(") and self.fits(content, k[len(form) + 1:-1]) for k in kind.split("/"))

    def attributes(self, reference):
        """Of all entities that the instance is: entity to its own values."""
        parts = self.parts[reference]
        found = {n: [] for part, _ in parts for n in lineage(part)}
        assert len(parts) == 1 or len(found) == len(parts), reference + ": parts of supertypes"
        for name, values in parts:
            wanted = [(n, k) for n in (lineage(name) if len(parts) == 1 else [name]) for k in OWN[n]]
            assert len(values) == len(wanted), "%s: %s has %d attributes" % (reference, name, len(values))
            for value, (n, kind) in zip(values, wanted):
                assert self.fits(value, kind), "%s: %s is not %s: %s" % (reference, name, kind, value)
                found[n].append(value[1])
        return found


def numbers(values):
    return [float(content) for _, content in values]


def check_knots(degree, multiplicities, knots, count):
    m, u = numbers(multiplicities), numbers(knots)
    assert len(u) == len(m) and sum(m) == count + int(degree) + 1 and max(m) <= int(degree) + 1, "knots"
    assert all(a < b for a, b in zip(u, u[1:])), "the order of knots"


def check_spline(a):
    if "b_spline_curve_with_knots" in a:
        degree, points = a["b_spline_curve"][:2]
        check_knots(degree, *a["b_spline_curve_with_knots"][:2], len(points))
        for weights in a.get("rational_b_spline_curve", []):
            assert len(weights) == len(points) and min(numbers(weights)) > 0, "weights"
    if "b_spline_surface_with_knots" in a:
        p, q, net = a["b_spline_surface"][:3]
        mu, mv, u, v = a["b_spline_surface_with_knots"][:4]
        sizes = [len(row) for _, row in net]
        assert min(sizes) == max(sizes), "rows of the net"
        check_knots(p, mu, u, len(net))
        check_knots(q, mv, v, sizes[0])
        for rows in a.get("rational_b_spline_surface", []):
            assert [len(r) for _, r in rows] == sizes and min(min(numbers(r)) for _, r in rows) > 0, "weights"


def check_shape(file, a):
    """The rules of loops, faces, shells, seams and triangles."""
    if "edge_loop" in a:
        chain = []
        for _, use in a["edge_loop"][0]:
            _, _, edge, forward = file.values[use]["oriented_edge"]
            start, end = file.values[edge]["edge"]
            chain.append((start, end) if forward == ".T." else (end, start))
        assert all(p[1] == q[0] for p, q in zip(chain, chain[1:] + chain[:1])), "a loop that is open"
    if "face" in a:
        assert sum(file.is_of(r, "face_outer_bound") for _, r in a["face"][0]) <= 1, "outer bounds"
    if "seam_curve" in a:
        assert len(a["surface_curve"][1]) == 2, "a seam has two sides"
    if "closed_shell" in a:
        uses = {}
        for _, face in a["connected_face_set"][0]:
            for _, bound in file.values[face]["face"][0]:
                loop, along = file.values[bound]["face_bound"]
                for _, use in (file.values[loop].get("edge_loop") or [[]])[0]:
                    _, _, edge, forward = file.values[use]["oriented_edge"]
                    uses.setdefault(edge, []).append(forward == along)
        assert all(sorted(u) == [False, True] for u in uses.values()), "a shell that is open or not turned alike"
    if "triangulated_face" in a:
        points, most, normals, _, _, triangles = a["triangulated_face"]
        count, places = file.values[points]["coordinates_list"]
        assert int(most) == int(count) == len(places) and len(normals) in (0, 1, int(most)), "numbers of points"
        assert all(1 <= int(i) <= int(most) for _, t in triangles for _, i in t), "corners"


failures = count = 0
for name in sys.argv[1:] or sorted(glob.glob("*.step")):
    reference = "its frame"
    try:
        file = File(open(name, encoding="utf-8").read())
        absent = {"CONFIG_CONTROL_DESIGN": NOT_IN_203, "AUTOMOTIVE_DESIGN": NOT_IN_214}.get(file.schema)
        for reference, values in file.values.items():
            check_spline(values)
            check_shape(file, values)
            assert not (absent and any(map(absent.search, values))), "not in the schema " + file.schema
        print("step: %s %d instances, %d kinds" % (name, len(file.parts), len({p[0] for i in file.parts.values() for p in i})))
    except (AssertionError, KeyError, IndexError, TypeError) as error:
        failures += 1
        print("step: %s %s: %s: %s  FAILED" % (name, reference, type(error).__name__, error))
    count += 1
print("WITNESS %d files, %d failed" % (count, failures))
sys.exit(failures > 0 or count == 0)
