#include "design/expect.h"

/* Reports of shapes whose measures are known in closed form. */

static const char shapes[] =
    "  ring: {circle: 2}\n"
    "  tilted: {circle: 2, axis: x}\n"
    "  square: {polyline: [[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]}\n"
    "  oblong: {polyline: [[0, 0], [4, 0], [4, 2], [0, 2], [0, 0]]}\n"
    "  open: {polyline: [[0, 0], [4, 0], [4, 3]]}\n"
    "  twisted: {polyline: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 1, 1], [0, 0, 0]]}\n"
    "  ducks: {points: [[0, 0], [1, 1], [3, -1], [4, 0]]}\n"
    "  wave: {bezier: ducks}\n"
    "  made: {interpolate: ducks}\n"
    "  parab: {points: [[-1, 1], [0, -1], [1, 1]]}\n"
    "  bow: {bezier: parab}\n"
    "  lifted: {move: bow, by: [1, 2]}\n"
    "  big: {scale: bow, by: 2}\n"
    "  loops: {points: [[0, 0], [3, 3], [-2, 3], [1, 0]]}\n"
    "  loop: {bezier: loops}\n"
    "  cusps: {points: [[0, 0], [1, 1], [0, 1], [1, 0]]}\n"
    "  cusp: {bezier: cusps}\n"
    "  q: {points: [[0, 0], [1, 2], [2, 2], [3, -1], [4, 0]]}\n"
    "  quart: {bezier: q}\n"
    "  sheet: {bilinear: [[0, 0], [4, 0], [4, 3], [0, 3]]}\n"
    "  drops: {points: [[0, 0, 0], [1, 0, 0], [0, 1, 1]]}\n"
    "  three: {bezier-triangle: drops}\n"
    "  ball: {sphere: 1}\n"
    "  mesh: {mesh: sheet}\n"
    "  round: {mesh: ball, chord: 0.1}\n"
    "  axis: {line: [[0, 0], [4, 0]]}\n"
    "  noisy: {least-squares: q, points: 2, degree: 1}\n"
    "  bumped: {points: [[0, 0], [1, 0], [2, 0.1], [3, 0], [4, 0], [5, 0]]}\n"
    "  fair: {fair: bumped, within: 0.2}\n"
    "  both: {collect: [open, axis]}\n";

TEST(measures_of_curves_are_those_of_geometry)
{
    static const expect_row rows[] = {
        {"m.txt: {measure: ring}", BATTEN_OK,
         "unit m\nring: closed, length 12.5663706\n  box -2 -2 0  to  2 2 0\n|: 4 x 4 x 0 about 0 0 0\n|area 12.5663706 in the "
         "xy-plane|  turning number 1\n|!inflection|!curvature is 0"},
        {"m.txt: {measure: tilted}", BATTEN_OK,
         "box 0 -2 -2  to  0 2 2|area 12.5663706 in the yz-plane"},
        {"m.txt: {measure: square}", BATTEN_OK,
         "closed, length 16\n|area 16 in the xy-plane, centroid 2 2 0\n  second moments about it 21.3333333 0 21.3333333, principal "
         "21.3333333 21.3333333 at 0 degrees\n  turning number 1\n  curvature is 0 at 0 4 8 12 16\n"},
        /* b h^3 / 12 and h b^3 / 12 */
        {"m.txt: {measure: oblong}", BATTEN_OK,
         "area 8 in|centroid 2 1 0|10.6666667|2.66666667"},
        {"m.txt: {measure: open}", BATTEN_OK,
         "open: length 7\n  box 0 0 0  to  4 3 0\n|: 4 x 3 x 0 about 2 1.5 0\n  no area: open by 5\n  turning number 0.25\n"},
        {"m.txt: {measure: open, within: 6}", BATTEN_OK, "closed, |!no area"},
        {"m.txt: {measure: wave}", BATTEN_OK,
         "  inflections at 0.5\n  curvature is 0 at 0.5\n  extrema of curvature at 0.0676971254 0.932302875\n"},
        {"m.txt: {measure: bow}", BATTEN_OK, "  extrema of curvature at 0.5\n|!inflections"},
        {"m.txt: {measure: loop}", BATTEN_OK, "crosses itself at 0.066987|0.933012"},
        {"m.txt: {measure: cusp}", BATTEN_OK, "at 0.5\n"},
        {"m.txt: {measure: twisted}", BATTEN_OK, "closed, |!area|!turning"},
        {"m.txt: {measure: ducks}", BATTEN_OK, "ducks: 4 points\n  box 0 -1 0  to  4 1 0\n"},
        {"m.txt: {measure: [open, axis]}", BATTEN_OK, "\nopen: length 7|\naxis: length 4"},
        {"m.json: {measure: [open, square]}", BATTEN_OK,
         "{\n  \"unit\": \"m\",\n  \"objects\": [\n    {\"name\": \"open\", \"type\": \"curve\", \"closed\": false, \"length\": 7|, \"gap\": "
         "5, \"box\": [[0, 0, 0], [4, 3, 0]], \"oriented_box\": {\"centre\": [2, 1.5, 0], \"axes\": [[|\"half\": [2, 1.5, 0]}, "
         "\"turning\": 0.25, \"inflections\": [], \"flat_points\": [0, 4, 7], \"curvature_extrema\": [], \"standstills\": [], "
         "\"self_crossings\": []},\n    {\"name\": \"square\"|\"plane\": \"xy\", \"area\": 16|\"centroid\": [2, 2, 0], \"moments\": "
         "[21.3333333333333|\"angle\": 0, \"turning\": 1|}\n  ]\n}\n"},
        {"m.json: {measure: wave}", BATTEN_OK, "\"turning\": 0, \"inflections\": [0.5"},
        {"m.json: {measure: loop}", BATTEN_OK,
         "\"self_crossings\": [0.0669872981077|, 0.9330127018922"},
    };
    EXPECT_OUTPUTS(shapes, rows);
}

TEST(measures_of_surfaces_and_meshes_are_those_of_geometry)
{
    static const expect_row rows[] = {
        {"s.txt: {measure: sheet}", BATTEN_OK, "sheet: area 12\n  box 0 0 0  to  4 3 0\n"},
        {"s.txt: {measure: three}", BATTEN_OK,
         "three: area 0.707106781\n  box 0 0 0  to  1 1 1\n"},
        {"s.txt: {measure: ball}", BATTEN_OK,
         "ball: area 12.5663706\n  box -1 -1 -1  to  1 1 1\n"},
        {"s.txt: {measure: mesh}", BATTEN_OK,
         "mesh: mesh, not closed, area 12\n  centroid of the area 2 1.5 0\n  box 0 0 0  to  4 3 0\n  2 triangles, 4 vertices, 5 edges, 1 piece\n  not closed for 4 edges at the rim\n"},
        {"s.txt: {measure: round}", BATTEN_OK,
         "round: mesh, |volume |1 piece|!not closed|!rim"},
        {"s.json: {measure: [sheet, three]}", BATTEN_OK,
         "{\"name\": \"sheet\", \"type\": \"surface\", \"area\": 12.|\"box\": [[0, 0, 0], [4, 3, 0]], \"box_error\": 0},\n    {\"name\": \"three\", \"type\": \"triangles\", \"area\": 0.70710678118654"},
        {"s.json: {measure: mesh}", BATTEN_OK,
         "\"type\": \"mesh\", \"closed\": false, \"area\": 12, \"area_error\": 0, \"volume\": 0, \"volume_error\": 0, \"centroid\": [2, 1.5, 0], \"box\": [[0, 0, 0], [4, 3, 0]], \"box_error\": 0, \"triangles\": 2, \"vertices\": 4, \"edges\": 5, \"pieces\": 1, \"rim_edges\": 4, \"wrong_edges\": 0, \"crowded_edges\": 0}"},
    };
    EXPECT_OUTPUTS(shapes, rows);
}

TEST(tables_matches_and_comparisons_have_the_numbers_of_their_curves)
{
    static const expect_row rows[] = {
        {"f.csv: {frame-table: axis, count: 3}", BATTEN_OK,
         "curve,parameter,length,x,y,z,xx,xy,xz,yx,yy,yz,tx,ty,tz\n1,0,0,0,0,0,0,1,0,0,0,1,1,0,0\n1,0.5,2|\n1,1,4"},
        {"f.csv: {frame-table: [axis, ring], count: 2, kind: fixed}", BATTEN_OK,
         "\n1,1,4|\n2,0,0,2,0,0"},
        {"f.csv: {frame-table: axis, count: 1}", BATTEN_BAD_ARGUMENT, "1 frame is asked for"},
        {"a.txt: {affine-match: [bow, lifted]}", BATTEN_OK,
         "lifted: an affine image of bow, to |\n  x' = 1 x |+ 1\n  y' = |+ 1 y + 2\n  parameter of bow = 1 v + 0\n"},
        {"a.txt: {affine-match: [bow, big, wave]}", BATTEN_OK,
         "big: an affine image of bow|x' = 2 x|wave: not an affine image of bow; the nearest found is "},
        {"a.txt: {affine-match: bow}", BATTEN_BAD_ARGUMENT, ""},
        {"a.json: {affine-match: [bow, lifted, wave]}", BATTEN_OK,
         "{\"from\": \"bow\", \"to\": \"lifted\", \"found\": true, \"error\": |\"offset\": [1, 2, 0], \"c\": 1, \"f\": 0},\n|\"to\": \"wave\", \"found\": false"},
        {"e.txt: {compare: [made, bow]}", BATTEN_OK,
         "feature |operation |\nmade |interpolate |\nbow |bezier |energy: integral of curvature^2; variation: of (d curvature / ds)^2; in m\n|!inf:"},
        {"e.txt: {compare: [bow, square]}", BATTEN_OK,
         " inf |\ninf: of a curve with corners both are infinite"},
        {"e.json: {compare: [bow, square]}", BATTEN_OK,
         "{\"curves\": [\n  {\"name\": \"bow\", \"operation\": \"bezier\"|\"corners\": 0, \"curvature_jumps\": 0|\"length\": 2.9578857|\"name\": \"square\"|\"energy\": null|\"corners\": "},
        {"e.txt: {compare: sheet}", BATTEN_BAD_ARGUMENT, "'sheet' has no curves to compare"},
        {"e.svg: {compare: [made, bow]}", BATTEN_OK, "<svg"},
        {"p.svg: {cubic-plane: [wave, loop]}", BATTEN_OK, "<svg"},
        {"p.txt: {cubic-plane: wave}", BATTEN_UNSUPPORTED,
         "'p.txt' must end in .png, .svg or .pdf"},
        {"p.svg: {cubic-plane: ducks}", BATTEN_BAD_ARGUMENT,
         "curves are needed, and 'ducks' has none"},
        {"p.svg: {cubic-plane: wave, from: 3, to: 1}", BATTEN_BAD_ARGUMENT,
         "the plane cannot be shown from 3 to 1"},
        {"p.svg: {picture: wave}", BATTEN_OK, "<svg"},
        {"p.txt: {picture: wave}", BATTEN_UNSUPPORTED,
         "'p.txt' must end in .png, .svg or .pdf"},
        {"p.svg: {picture: sheet, shading: zebra}", BATTEN_UNSUPPORTED,
         "shaded pictures are written as .png, not as 'p.svg'"},
        {"p.png: {picture: wave, shading: zebra}", BATTEN_BAD_ARGUMENT,
         "'shading' needs a surface, body or mesh"},
        {"l.txt: {lines-plan: sheet}", BATTEN_UNSUPPORTED,
         "'l.txt' must end in .pdf, .svg, .png or .dxf"},
        {"w.xyz: {write: ducks}", BATTEN_OK, "1 1|3 -1"},
        {"w.txt: {write: ducks, format: points}", BATTEN_OK, "3 -1"},
        {"w.foo: {write: ducks}", BATTEN_UNSUPPORTED, "w.foo"},
        {"g.nc: {g-code: open}", BATTEN_OK, "G"},
    };
    EXPECT_OUTPUTS(shapes, rows);
}

TEST(reports_say_what_was_done_and_what_holds)
{
    static const expect_row rows[] = {
        {"k.txt: {check: made}", BATTEN_OK,
         "What was done\n  ducks (points)\n  made (interpolate)\n\nThe result\n  made (curve)\n    1 inflection, 0 in excess; curvature extrema 2|distance from the 4 points given, 'made': at most |Verdict: fair"},
        {"k.txt: {check: made, title: Hull 7}", BATTEN_BAD_FORMAT,
         "check has no parameter 'title'"},
        {"k.txt: {check: made, within: 0.001}", BATTEN_OK, "the points given |within 0.001 m"},
        {"k.txt: {check: noisy, within: 0.001}", BATTEN_OK,
         "error at most 2 m\n|at most 2 m (rms 1.342), at 1, 2, 0\n|Verdict: fair as a curve; the points given lie farther than 0.001 m from the shape."},
        {"k.txt: {check: fair}", BATTEN_OK,
         "fair (fair)\n    |4 points moved, at most 0.09|3 |before, 0 |after\n"},
        {"k.txt: {check: mesh}", BATTEN_OK, "mesh (mesh)|not closed"},
        {"k.txt: {check: round}", BATTEN_OK, "closed; 1 piece|No verdict: "},
        {"k.txt: {check: both}", BATTEN_OK, "What meets\n|open|axis|gap 0"},
        {"k.txt: {check: three}", BATTEN_OK, "1 triangle of degree 1"},
        {"k.json: {check: made}", BATTEN_OK,
         "\"ok\": true, \"fair\": true, \"unit\": \"m\", \"within\": null,\n  \"features\": [\n    {\"name\": \"ducks\", \"operation\": \"points\"},\n    {\"name\": \"made\", \"operation\": \"interpolate\"}\n  ],\n|\"inflections\": 1, \"excess_inflections\": 0, \"curvature_extrema\": 2, \"jumps\": 0|\"distances\": [{\"from\": \"made\", \"faired\": false, \"points\": 4|\"joins\": [],\n  \"worst_joins\": [],\n  \"messages\": ["},
        {"k.json: {check: noisy, within: 0.001}", BATTEN_OK, "\"ok\": false|\"within\": 0.001"},
        {"k.json: {check: both}", BATTEN_OK,
         "\"joins\": [\n    {\"a\": \"open\", \"side_a\": \"start\", \"b\": \"axis\", \"side_b\": \"start\", \"g0\": 0"},
        {"k.json: {check: fair}", BATTEN_OK,
         "\"operation\": \"fair\", |\"excess_inflections\": |4"},
        {"k.json: {check: mesh}", BATTEN_OK, "\"ok\": |\"type\": \"mesh\""},
    };
    EXPECT_OUTPUTS(shapes, rows);
}

/* ---- figures of files, plans and comparisons ---- */

static const char flats[] =
    "  p: {points: [[0, 0, 0], [2, 0, 0], [0, 1, 0], [2, 1, 0]], columns: 2}\n"
    "  flat: {interpolate-grid: p, degree-u: 1, degree-v: 1}\n"
    "  sheet: {bilinear: [[0, 0], [4, 0], [4, 3], [0, 3]]}\n"
    "  mesh: {mesh: sheet}\n"
    "  drops: {points: [[0, 0, 0], [1, 0, 0], [0, 1, 1]]}\n"
    "  three: {bezier-triangle: drops}\n"
    "  dots: {points: [[0, 0, 0], [1, 0, 0]]}\n"
    "  net: {points: [[0, 0], [0, 0], [1, 0], [1, 1]]}\n"
    "  halt: {bezier: net}\n"
    "  arm: {arc: 2, angle: 90 deg}\n"
    "  leg: {line: [[2, -1], [2, 0]]}\n"
    "  joined: {join: [leg, arm]}\n"
    "  elbow: {polyline: [[0, 0], [1, 0], [1, 1]]}\n";

/* A hint where the gap is less than a twentieth of the length. */
TEST(ends_that_nearly_meet_are_told_how_to_close)
{
    static const char gaps[] = "  near: {polyline: [[0, 0], [10, 0], [10, 1], [0, 1]]}\n"
                               "  wide: {polyline: [[0, 0], [9, 0], [9, 1], [0, 1]]}\n";
    static const expect_row rows[] = {
        {"m.txt: {measure: near}", BATTEN_OK,
         "length 21\n|no area: open by 1; 'within' (--within), when it is more, closes it\n"},
        {"m.txt: {measure: wide}", BATTEN_OK, "length 19\n|no area: open by 1\n"},
        {"m.txt: {measure: near, within: 1.01}", BATTEN_OK, "near: closed, length 21|!no area"},
    };
    EXPECT_OUTPUTS(gaps, rows);
}

TEST(files_and_plans_have_the_titles_that_are_given)
{
    static const expect_row rows[] = {
        {"w.step: {write: flat, title: Hull 7}", BATTEN_OK, "'Hull 7'"},
        {"w.step: {write: flat}", BATTEN_OK, "!'Hull 7'"},
        {"w.stl: {write: flat, text: yes}", BATTEN_OK, "facet normal"},
        {"w.stl: {write: flat}", BATTEN_OK, "!facet normal"},
        {"w.none: {write: flat}", BATTEN_UNSUPPORTED,
         "the ending of 'w.none' names no format; add 'format'"},
        {"w.none: {write: flat, format: step}", BATTEN_OK, "ISO-10303-21;"},
    };
    EXPECT_OUTPUTS(flats, rows);
}

TEST(without_points_or_edges_there_is_no_verdict_and_why)
{
    static const expect_row rows[] = {
        {"k.txt: {check: sheet}", BATTEN_OK,
         "No verdict: fairness is judged of curves, of surfaces with their points, and of edges where surfaces meet"},
        {"k.txt: {check: mesh}", BATTEN_OK, "No verdict: fairness is judged of curves"},
        {"k.txt: {check: three}", BATTEN_OK, "No verdict: fairness is judged of curves"},
        {"k.txt: {check: dots}", BATTEN_OK, "No verdict: points alone are not judged"},
        {"k.txt: {check: arm}", BATTEN_OK, "!No verdict|Verdict: fair"},
    };
    EXPECT_OUTPUTS(flats, rows);
}

/* Of a quarter of a circle of radius 2 energy is length over r^2. */
TEST(a_comparison_says_what_is_infinite_and_why)
{
    static const expect_row rows[] = {
        {"e.txt: {compare: [arm, elbow]}", BATTEN_OK, "inf"},
        {"e.svg: {compare: [arm, elbow, joined, halt]}", BATTEN_OK, "<svg"},
        {"e.json: {compare: arm}", BATTEN_OK,
         "\"corners\": 0, \"curvature_jumps\": 0|\"length\": 3.14159265358979"},
        {"e.json: {compare: joined}", BATTEN_OK,
         "\"corners\": 0, \"curvature_jumps\": 1|\"length\": 4.1415926"},
        {"e.json: {compare: elbow}", BATTEN_OK, "\"corners\": 1|\"length\": 2"},
    };
    EXPECT_OUTPUTS(flats, rows);
}
