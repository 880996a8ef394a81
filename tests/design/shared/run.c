#include "design/evaluate.h"
#include "design/expect.h"

#include <stdlib.h>

static batten_status make(const char *features, batten_design **design)
{
    char text[900];
    snprintf(text, sizeof text, "batten: 1\nfeatures:\n%s", features);
    batten_design *made = NULL;
    batten_status status = batten_design_parse(text, strlen(text), NULL, NULL, &made);
    if (status == BATTEN_OK)
        status = batten_design_evaluate(made, NULL, NULL, NULL);
    if (status == BATTEN_OK)
        *design = made;
    else
        batten_design_free(made);
    return status;
}

static const batten_object *object(const batten_design *design, const char *feature, int index)
{
    return batten_model_object(batten_design_result(design, feature)->value, index);
}

TEST(an_operation_applies_to_all_objects_of_its_kind)
{
    batten_design *design = NULL;
    CHECK_OK(make(
        "  a: {line: [[0, 0], [3, 0]]}\n  b: {line: [[0, 1], [3, 1]]}\n  p: {points: [0, 9]}\n"
        "  all: {collect: [a, b, p]}\n  up: {elevate: all, by: 2}\n",
        &design));
    CHECK_INT(batten_model_count(batten_design_result(design, "up")->value), 3);
    CHECK_INT(batten_curve_degree(object(design, "up", 0)->curve), 3);
    CHECK_INT(batten_curve_degree(object(design, "up", 1)->curve), 3);
    CHECK_INT(object(design, "up", 2)->kind, BATTEN_OBJECT_POINTS);
    CHECK_TEXT(object(design, "up", 1)->name, "b");
    batten_design_free(design);
}

TEST(what_is_missing_for_an_operation_is_said)
{
    batten_design *design = NULL;
    CHECK_STATUS(make("  p: {points: [0, 9]}\n  e: {elevate: p}\n", &design),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("e (elevate): curves or surfaces or triangles are needed, and 'p' has none");
    CHECK_STATUS(make("  p: {points: [0, 9]}\n  e: {swap: p}\n", &design), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("surfaces are needed");
}

TEST(a_mirrored_mirror_image_is_the_original)
{
    batten_design *design = NULL;
    CHECK_OK(make(
        "  a: {interpolate: p}\n  p: {points: [[0, 1, 2], [3, 2, 1], [4, 4, 1], [7, 5, 3]]}\n"
        "  b: {mirror: a, keep: no}\n  c: {mirror: b, keep: no}\n  both: {mirror: a}\n",
        &design));
    const batten_object *a = object(design, "a", 0), *c = object(design, "c", 0);
    for (int i = 0; i < 3 * batten_curve_point_count(a->curve); i++)
        CHECK_NEAR(batten_curve_points(a->curve)[i], batten_curve_points(c->curve)[i], 1e-14);
    for (int i = 0; i < 3 * a->point_count; i++)
        CHECK_NEAR(a->points[i], c->points[i], 1e-15);
    CHECK_NEAR(object(design, "b", 0)->points[1], -1, 0);
    CHECK_INT(batten_model_count(batten_design_result(design, "both")->value), 2);
    CHECK_TEXT(object(design, "both", 1)->name, "a mirrored");
    batten_design_free(design);
}

TEST(moving_rotating_and_scaling_do_what_they_say)
{
    static const struct {
        const char *feature;
        double x, y, z;
    } rows[] = {{"{move: p, by: [1, 2, 3]}", 2, 2, 3},
                {"{rotate: p, by: 90 deg}", 0, 1, 0},
                {"{rotate: p, by: 180 deg, at: [2, 0, 0]}", 3, 0, 0},
                {"{scale: p, by: 3}", 3, 0, 0},
                {"{scale: p, by: [2, 1, 1], at: [3, 0, 0]}", -1, 0, 0},
                {"{mirror: p, normal: [2, 0, 0], at: 4, keep: no}", 7, 0, 0},
                {"{mirror: p, plane: x, at: 4, keep: no}", 7, 0, 0}};
    for (int i = 0; i < COUNT(rows); i++) {
        char text[200];
        batten_design *design = NULL;
        snprintf(text, sizeof text, "  p: {points: x}\n  a: %s\n", rows[i].feature);
        CHECK_OK(make(text, &design));
        const double *p = object(design, "a", 0)->points;
        CHECK_NEAR(p[0], rows[i].x, 1e-15);
        CHECK_NEAR(p[1], rows[i].y, 1e-15);
        CHECK_NEAR(p[2], rows[i].z, 1e-15);
        batten_design_free(design);
    }
}

TEST(G1_points_that_coincide_are_named)
{
    batten_design *design = NULL;
    CHECK_STATUS(
        make("  p: {points: [[0, 0], [1, 1], [1, 1], [2, 0]]}\n  c: {interpolate: p}\n",
             &design),
        BATTEN_COINCIDENT);
    CHECK_MESSAGE("c (interpolate): p: ");
}

TEST(G2_two_points_give_their_line)
{
    batten_design *design = NULL;
    CHECK_OK(make("  p: {points: [[0, 0], [1, 1]]}\n  c: {interpolate: p}\n", &design));
    double point[3];
    CHECK_OK(batten_curve_evaluate(object(design, "c", 0)->curve,
                                   0.5 * batten_curve_domain(object(design, "c", 0)->curve).b,
                                   0, point));
    CHECK_NEAR(point[0], 0.5, 1e-15);
    CHECK_NEAR(point[1], 0.5, 1e-15);
    batten_design_free(design);
}

TEST(wrong_numbers_of_points_and_factors_are_refused)
{
    static const char *const rows[] = {
        "{line: [[0, 0]]}",
        "{line: [[0, 0], [1, 1], [2, 2]]}",
        "{conic: [[0, 0], [1, 1]]}",
        "{conic: [[0, 0, 1], [1, 1], [2, 0]], through: [1, 0.3]}",
        "{scale: p, by: [1, 2]}",
        "{scale: p, by: 0}",
        "{points: [[0, 0], [1, 1], [2, 2]], columns: 2}",
        "{points: [[0, 0]], columns: 0}",
        "{move: p, by: [1]}",
        "{mirror: p, normal: origin}",
        "{rotate: p, by: 1 rad, axis: origin}"};
    for (int i = 0; i < COUNT(rows); i++) {
        char text[200];
        batten_design *design = NULL;
        snprintf(text, sizeof text, "  p: {points: x}\n  a: %s\n", rows[i]);
        batten_status status = make(text, &design);
        if (test_memory_failed(status, BATTEN_OK))
            status = make(text, &design);
        CHECK(status == BATTEN_BAD_ARGUMENT || status == BATTEN_BAD_FORMAT);
    }
}

/* A closed surface encloses a volume above 0; turned inside out it would be below. */
TEST(a_mirrored_surface_is_not_inside_out)
{
    static const char *const shapes[] = {"{torus: 2 m, minor: 1 m}", "{sphere: 1 m}"};
    for (int i = 0; i < COUNT(shapes); i++) {
        char text[300];
        batten_design *design = NULL;
        double volumes[2];
        snprintf(text, sizeof text,
                 "  s: %s\n  m: {mirror: s, plane: x, at: 3 m}\n  facets: {mesh: m}\n",
                 shapes[i]);
        CHECK_OK(make(text, &design));
        for (int k = 0; k < 2; k++) {
            batten_mesh_facts facts;
            CHECK_OK(batten_mesh_check(object(design, "facets", k)->mesh, &facts));
            CHECK(facts.is_watertight);
            volumes[k] = facts.volume;
        }
        CHECK(volumes[0] > 1);
        CHECK_NEAR(volumes[1], volumes[0], 1e-3 * volumes[0]);
        batten_design_free(design);
    }
}

static const char shapes[] =
    "  net: {points: [[0, 0, 0], [1, 0, 0], [0, 1, 1]]}\n"
    "  sail: {bezier-triangle: net}\n"
    "  sheet: {bilinear: [[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 3, 0]]}\n"
    "  line: {line: [[0, 0], [4, 0]]}\n"
    "  ducks: {points: [[0, 0], [1, 1], [3, 1], [4, 0]]}\n"
    "  chain: {arc-spline: ducks, ends: circular}\n"
    "  made: {interpolate: ducks}\n"
    "  all: {collect: [sail, sheet, line, ducks]}\n"
    "  can: {cylinder: 1, height: 4}\n"
    "  flat: {unroll: can, lines: 1}\n"
    "  corner: {polyline: [[0, 0], [4, 0], [4, 3]]}\n";

static const expect_row changes[] = {
    {"{elevate: sail, by: 2}", BATTEN_OK,
     "kind triangles;degree 3;count 1;at 0 0 0 0 0;at 1 0 1 0 0;at 0 1 0 1 1"},
    {"{elevate: sheet, by: 2}", BATTEN_OK, "kind surface;degree 3 1;area 12;exact"},
    {"{elevate: sheet, by: 2, direction: v}", BATTEN_OK, "degree 1 3;area 12"},
    {"{elevate: all, by: 1}", BATTEN_OK,
     "objects 4;named sail;kind triangles;degree 2;object 1;named sheet;degree 2 1;object 2;named "
     "line;degree 2;object 3;named ducks;kind points;count 4"},
    {"{elevate: made, by: 1}", BATTEN_OK, "degree 4;passes;data 3 4 0 0"},
    {"{reverse: chain}", BATTEN_OK, "spans 3;at 0 4 0 0;at 1 0 0 0"},
    {"{swap: all}", BATTEN_OK, "objects 4;object 1;named sheet;at 1 0 0 3 0;at 0 1 4 0 0"},
    {"{swap: line}", BATTEN_BAD_ARGUMENT, "surfaces are needed, and 'line' has none"},
    {"{reverse: flat}", BATTEN_OK,
     "objects 2;layer cut;colour 0 0 0;object 1;layer rulings;colour 0.6 0.6 0.6"},
    {"{reduce: sheet, degree: 1, within: 1}", BATTEN_OK, "degree 1 1;error 1e-12"},
    {"{move: all, by: [0, 0, 2]}", BATTEN_OK,
     "objects 4;named sail;object 1;on 0 0 1 2;object 3;data 1 1 1 2"},
    {"{remove-knots: corner, within: 0.01}", BATTEN_OK, "error 0.01"},
};

TEST(changes_keep_kinds_names_layers_colours_and_data)
{
    EXPECT(shapes, changes);
}

static batten_status evaluate_at_most(int most, batten_design **out)
{
    char text[300];
    snprintf(
        text, sizeof text,
        "batten: 1\nmost-objects: %d\nfeatures:\n  a: {line: [[0, 0], [1, 0]]}\n  b: {collect: "
        "[a, a]}\n",
        most);
    return evaluate_design(text, "b", NULL, out);
}

TEST(a_design_makes_as_many_objects_as_it_allows_and_no_more)
{
    batten_design *design = NULL;
    CHECK_OK(evaluate_at_most(3, &design));
    batten_design_free(design);
    CHECK_STATUS(evaluate_at_most(2, &design), BATTEN_TOO_LARGE);
    CHECK_MESSAGE("with it the design would have made 3 objects, more than 2; a line "
                  "'most-objects: 3' in the design allows them");
}
