#include "design/expect.h"
#include "design/picture_size.h"

/* Comparisons of curves whose bending has a closed form. Of y = x^2 from -1 to 1 the energy is 4 (s - s^3 / 3) and the
 * variation 144 (s^3 / 3 - 3 s^5 / 5 + 3 s^7 / 7 - s^9 / 9) with s = 2 / sqrt 5, the largest curvature 2. */

static const char curves[] =
    "  ring: {circle: 2}\n"
    "  vee: {points: [[-1, 1], [0, -1], [1, 1]]}\n"
    "  bow: {bezier: vee}\n"
    "  standing: {points: [[-1, 0, 1], [0, 0, -1], [1, 0, 1]]}\n"
    "  upright: {bezier: standing}\n"
    "  turned: {rotate: bow, by: 30 deg, axis: [1, 1, 1]}\n"
    "  ess: {points: [[0, 0], [1, 2], [2, -2], [3, 0]]}\n"
    "  wave: {bezier: ess}\n"
    "  tilted: {rotate: wave, by: 40 deg, axis: [1, 2, 3]}\n"
    "  screw: {points: [[0, 0, 0], [1, 2, 0], [2, -2, 1], [3, 0, 2]]}\n"
    "  twisted: {bezier: screw}\n"
    "  open: {polyline: [[0, 0], [4, 0], [4, 3]]}\n"
    "  both: {collect: [ring, bow, vee]}\n"
    "  round: {fillet: open, radius: 1}\n"
    "  straight: {line: [[0, 0], [0, 5]]}\n"
    "  arcs: {biarcs: vee}\n"
    "  a_curve_with_a_long_name: {move: bow, by: [0, 0, 1]}\n";

static const expect_row tables[] = {
    {"c.txt: {compare: bow}", BATTEN_OK,
     "feature            operation                energy    variation inflections  extrema   max "
     "curv       length        ms\n"
     "bow                bezier                  2.62365      7.28789           0        1       "
     "   2    2.9578857 |\n\nenergy: integral of curvature^2; variation: of (d curvature / ds)^2; "
     "in m\n|!inf:"},
    {"c.txt: {compare: [ring, upright, straight]}", BATTEN_OK,
     "\nring               circle                  3.14159            0           0        0     "
     "   0.5    12.566371 |"
     "\nupright            bezier                  2.62365      7.28789           0        1     "
     "     2    2.9578857 |"
     "\nstraight           line                          0            0           0        0     "
     "     0            5 |!inf:"},
    /* A plane curve is one in every plane. */
    {"c.txt: {compare: turned}", BATTEN_OK,
     "\nturned             rotate                  2.62365      7.28789           0        1     "
     "     2    2.9578857 |"},
    {"c.txt: {compare: [wave, tilted]}", BATTEN_OK,
     "\nwave               bezier                  |           1        2 "
     "|\ntilted             rotate                  |           1        2 "},
    /* Curvature of a curve in space has no sign. */
    {"c.txt: {compare: twisted}", BATTEN_OK,
     "\ntwisted            bezier |           -        - "},
    /* Of two curves integrals, lengths and counts are sums, the largest curvature is the larger one. */
    {"c.txt: {compare: both}", BATTEN_OK,
     "\nboth               collect                 5.76525      7.28789           0        1     "
     "     2    15.524256 |"},
    /* A quarter of a circle of radius 1 between straight lines of 3 and 2. */
    {"c.txt: {compare: round}", BATTEN_OK,
     "\nround              fillet                   1.5708          inf           0        0     "
     "     1    6.5707963 |\ninf: of a curve with corners both are infinite, of one whose "
     "curvature jumps the variation;\ncurvature is where a curve stands still and its curvature "
     "has no bound\n"},
    {"c.txt: {compare: open}", BATTEN_OK,
     "\nopen               polyline                    inf          inf           0        0     "
     "     0            7 |\ninf: "},
    {"c.txt: {compare: [bow, a_curve_with_a_long_name]}", BATTEN_OK,
     "feature                  operation  |\nbow                      bezier     "
     "|\na_curve_with_a_long_name move                    2.62365"},
    {"c.json: {compare: [bow, open, twisted]}", BATTEN_OK,
     "{\"curves\": [\n  {\"name\": \"bow\", \"operation\": \"bezier\", \"energy\": "
     "2.6236530|, \"variation\": 7.28789497|, \"corners\": 0, \"curvature_jumps\": 0, "
     "\"inflections\": 0, \"curvature_extrema\": 1, \"max_curvature\": 2, \"length\": "
     "2.9578857|, \"seconds\": |},\n  {\"name\": \"open\", \"operation\": \"polyline\", "
     "\"energy\": null, \"variation\": null, \"corners\": 1, \"curvature_jumps\": 0, "
     "\"inflections\": 0, \"curvature_extrema\": 0, \"max_curvature\": 0, \"length\": 7|},\n  "
     "{\"name\": \"twisted\"|\"corners\": 0, \"curvature_jumps\": 0, \"max_curvature\": |}\n]}\n"},
    {"c.json: {compare: round}", BATTEN_OK,
     "\"energy\": 1.5707963|\"variation\": null, \"corners\": 0, \"curvature_jumps\": 2, "
     "\"inflections\": 0"},
    {"c.json: {compare: arcs}", BATTEN_OK, "\"operation\": \"biarcs\"|\"corners\": 0"},
    {"c.txt: {compare: [bow, vee]}", BATTEN_BAD_ARGUMENT, "'vee' has no curves to compare"},
    {"c: {compare: bow}", BATTEN_OK, "feature            operation "},
    {"c.svg: {compare: bow, width: 500, height: 300}", BATTEN_OK,
     "width=\"500pt\" height=\"300pt\""},
    {"c.svg: {compare: bow}", BATTEN_OK, "width=\"1600pt\""},
};

TEST(comparisons_have_the_energies_counts_and_lengths_of_their_curves)
{
    EXPECT_OUTPUTS(curves, tables);
}

TEST(pictures_of_comparisons_have_combs_titles_and_a_panel_for_each_curve)
{
    const size_t plain = picture_size(curves, "compare: bow");
    const size_t bare = picture_size(curves, "compare: bow, comb: no");
    CHECK(plain == picture_size(curves, "compare: bow, comb: yes"));
    CHECK(plain > bare);
    CHECK(plain < picture_size(curves, "compare: bow, title: Four ways"));
    CHECK(picture_size(curves, "compare: [bow, upright], comb: no") > bare);
}
