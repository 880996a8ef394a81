#include "support/test.h"

#include <batten/design.h>
#include <string.h>

/* The bytes of the first output of a design, as the test's. */
static const char *output_of(const char *text)
{
    batten_design *design = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_design_parse(text, strlen(text), NULL, NULL, &design));
    CHECK_OK(batten_design_output(design, 0, NULL, NULL, &data, &size));
    char *copy = test_array(size + 1, 1);
    memcpy(copy, data, size);
    batten_release(data);
    batten_design_free(design);
    return copy;
}

TEST(a_report_of_cubics_says_what_each_span_is)
{
    static const char design[] =
        "batten: 1\nfeatures:\n"
        "  ducks: {points: [[0, 0], [3, 0.4], [3.3, 1], [3.4, 2], [2.2, 3], [2, 3.02], [0.3, "
        "2]]}\n"
        "  c: {interpolate: ducks, parameters: uniform, ends: natural}\n"
        "outputs:\n  a.txt: {classify: c}\n";
    const char *text = output_of(design);
    CHECK_CONTAINS(text, "c: 6 spans");
    CHECK_CONTAINS(text, "span 5: a loop");
    CHECK_CONTAINS(text, "crosses itself at ");
    CHECK_CONTAINS(text, "(regular)");
}

TEST(a_report_of_cubics_in_json_has_all_keys)
{
    static const char design[] = "batten: 1\nfeatures:\n"
                                 "  l: {line: [[0, 0], [1, 0]]}\n"
                                 "outputs:\n  a.json: {classify: l}\n";
    const char *text = output_of(design);
    CHECK_CONTAINS(text, "\"segment\": \"line\"");
    CHECK_CONTAINS(text, "\"invariant\": null");
    CHECK_CONTAINS(text, "\"inflections\": []");
}

/* Does a note of the design, or the message of its failure, contain these words? A note may be
 * lost where memory fails. */
static void check_said(const char *text, batten_status expected, const char *words)
{
    batten_notes *notes = NULL;
    batten_design *design = NULL;
    char *all = test_array(2000, 1);
    CHECK_OK(batten_notes_create(20, &notes));
    CHECK_OK(batten_design_parse(text, strlen(text), NULL, notes, &design));
    CHECK_STATUS(batten_design_evaluate(design, NULL, NULL, notes), expected);
    if (expected != BATTEN_OK)
        CHECK_MESSAGE(words);
    for (int i = 0; i < batten_notes_count(notes); i++)
        strncat(all, batten_notes_at(notes, i)->text, 200);
    if (expected == BATTEN_OK && batten_notes_dropped(notes) == 0)
        CHECK_CONTAINS(all, words);
    batten_design_free(design);
    batten_notes_free(notes);
}

#define UNEVEN                                                                               \
    "batten: 1\nfeatures:\n"                                                                 \
    "  p: {points: [[0, 0], [3, 0.4], [3.3, 1], [3.4, 2], [2.2, 3], [2, 3.02], [0.3, 2]]}\n" \
    "  c: {interpolate: p, parameters: uniform, ends: natural}\n"

TEST(a_correction_says_what_it_did)
{
    check_said(UNEVEN "  d: {corrected: c}\n", BATTEN_OK, "of 6 spans corrected");
    const char *text = output_of(UNEVEN "  d: {corrected: c, joins: curvature}\n"
                                        "outputs:\n  a.txt: {classify: d}\n");
    CHECK(strstr(text, ": a loop") == NULL);
    CHECK_CONTAINS(text, "d: 6 spans");
}

TEST(directions_against_the_points_are_noted)
{
    check_said("batten: 1\nfeatures:\n  p: {points: [[0, 0], [1, 0], [2, 0]]}\n"
               "  d: {directed-spline: p, at: [2], directions: [[-1, 0.1]]}\n",
               BATTEN_OK, "lead against the points, the first at point 2");
    check_said("batten: 1\nfeatures:\n  p: {points: [[0, 0], [1, 0], [2, 0]]}\n"
               "  d: {directed-spline: p, at: [2, 3], directions: [[-1, 0.1]]}\n",
               BATTEN_NOT_COMPATIBLE, "names 2 points");
}

TEST(n4_corners_that_are_no_points_are_refused)
{
    check_said("batten: 1\nfeatures:\n  p: {points: [[0, 0], [1, 0], [2, 1]]}\n"
               "  d: {cornered-spline: p, corners: [6]}\n",
               BATTEN_BAD_ARGUMENT, "corner 1 is point 6");
}

#define QUINTIC                                                                             \
    "batten: 1\nfeatures:\n" /* (40 t^2, 10 (t^5 + t^4 - 3 t^3 + t)) from -7/4 to 7/4 */    \
    "  p: {points: [[122.5, 72.939453125], [24.5, 65.201171875], [-24.5, -181.029296875], " \
    "[-24.5, 218.544921875], [24.5, -177.748046875], [122.5, 114.638671875]]}\n"            \
    "  c: {bezier: p}\n"

TEST(a_report_of_higher_degrees_counts_what_is_on_each_span)
{
    const char *text = output_of(QUINTIC "outputs:\n  a.txt: {classify: c}\n");
    CHECK_CONTAINS(text, "c: 1 span, 2 inflections, 2 crossings");
    CHECK_CONTAINS(text, "span 1: degree 5, plane, 2 inflections, 2 crossings, margin 0.00");
    CHECK_CONTAINS(text, "; inflection at 0.18");
    CHECK_CONTAINS(text, "; crosses itself at 0.0377046 and 0.962295");
}

TEST(a_report_of_higher_degrees_in_json_has_all_keys)
{
    const char *text = output_of(QUINTIC "outputs:\n  a.json: {classify: c}\n");
    CHECK_CONTAINS(text, "\"degree\": 5, \"dimension\": 2, \"complete\": true");
    CHECK_CONTAINS(text, "\"whole_counts\": {\"inflections\": 2, \"undulations\": 0");
    CHECK_CONTAINS(text, "\"complex\": 0, \"infinite\": 4");
    CHECK_CONTAINS(text, "{\"kind\": \"crossing\", \"inside\": true, \"multiplicity\": 1");
}

TEST(a_degree_that_elimination_cannot_reach_is_said_to_be_searched)
{
    char design[2000] = "batten: 1\nfeatures:\n  p: {points: [";
    size_t length = strlen(design);
    for (int i = 0; i < 20; i++)
        length += (size_t)snprintf(design + length, sizeof design - length, "%s[%d.3, %d.%d7]",
                                   i ? ", " : "", (i * 5) % 11, (i * 7) % 5, (i * 3) % 8);
    snprintf(design + length, sizeof design - length,
             "]}\n  c: {bezier: p}\noutputs:\n  a.txt: {classify: c}\n");
    CHECK_CONTAINS(output_of(design), "perhaps not all");
}

TEST(a_report_in_json_has_the_canonical_form)
{
    const char *text = output_of(QUINTIC "outputs:\n  a.json: {classify: c}\n");
    CHECK_CONTAINS(text, "\"pivots\": [2, 5], \"shift\": 0.5, \"radius\": ");
    CHECK_CONTAINS(text, "{\"row\": 2, \"power\": 4, \"weight\": 1, \"value\": ");
    CHECK_CONTAINS(text, "\"quintic\": \"two nodes\"");
    CHECK_CONTAINS(output_of(QUINTIC "outputs:\n  a.txt: {classify: c}\n"),
                   "a quintic with two finite double points: two nodes");
}

TEST(a_report_says_which_map_makes_one_curve_of_another)
{
    const char *text = output_of(QUINTIC "  d: {scale: c, by: [2, 1, 1]}\n"
                                         "  e: {part: d, from: 0.25, to: 0.75}\n"
                                         "  f: {reverse: e}\n"
                                         "outputs:\n  a.txt: {affine-match: [c, d, f]}\n");
    CHECK_CONTAINS(text, "d: an affine image of c, to ");
    CHECK_CONTAINS(text, "  x' = 2 x");
    CHECK_CONTAINS(text, "f: an affine image of c, to ");
    CHECK_CONTAINS(text, ", of another part of the same curve");
}

TEST(a_match_that_is_asked_for_and_not_found_is_reported)
{
    static const char two[] = QUINTIC "  q: {points: [[0, 0], [1, 2], [3, 1], [4, 5]]}\n"
                                      "  d: {bezier: q}\n"
                                      "outputs:\n  a.json: {affine-match: [c, d]}\n";
    const char *text = output_of(two);
    CHECK_CONTAINS(text, "\"from\": \"c\", \"to\": \"d\", \"found\": false");
}

TEST(a_match_needs_two_curves)
{
    static const char one[] = QUINTIC "outputs:\n  a.txt: {affine-match: c}\n";
    batten_design *design = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_design_parse(one, strlen(one), NULL, NULL, &design));
    CHECK_STATUS(batten_design_output(design, 0, NULL, NULL, &data, &size),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("two curves or more");
    batten_design_free(design);
}

TEST(affine_lengths_divide_a_curve)
{
    const char *text = output_of(QUINTIC "  d: {divide: c, count: 4, by: affine}\n"
                                         "  e: {interpolate: d, ends: natural}\n"
                                         "outputs:\n  a.txt: {classify: e}\n");
    CHECK_CONTAINS(text, ": 4 spans");
    check_said("batten: 1\nfeatures:\n  l: {line: [[0, 0], [1, 0]]}\n"
               "  d: {divide: l, count: 4, by: affine}\n",
               BATTEN_SINGULAR_HERE, "straight");
}

TEST(a_match_within_a_bound_that_is_not_found_does_not_hold)
{
    static const char two[] =
        QUINTIC "  q: {points: [[0, 0], [1, 2], [3, 1], [4, 5]]}\n"
                "  d: {bezier: q}\n"
                "outputs:\n  a.txt: {affine-match: [c, d], within: 1 mm}\n"
                "  b.txt: {affine-match: [c, d]}\n";
    batten_notes *notes = NULL;
    batten_design *design = NULL;
    CHECK_OK(batten_notes_create(5, &notes));
    CHECK_OK(batten_design_parse(two, strlen(two), NULL, NULL, &design));
    for (int i = 0; i < 2; i++) {
        char *data = NULL;
        size_t size = 0;
        CHECK_OK(batten_design_output(design, i, NULL, notes, &data, &size));
        CHECK_INT(batten_design_output_holds(design, i), i == 1);
        const int last = batten_notes_count(notes) - 1; /* may be lost where memory fails */
        if (i == 0 && last >= 0 && batten_notes_dropped(notes) == 0)
            CHECK_CONTAINS(batten_notes_at(notes, last)->text, "is not an affine image of 'c'");
        batten_release(data);
    }
    batten_design_free(design);
    batten_notes_free(notes);
}
