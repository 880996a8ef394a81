#include "design/evaluate.h"

#include <stdlib.h>

static batten_status evaluate(const char *text, batten_notes *notes, batten_design **out)
{
    return evaluate_design(text, "a", notes, out);
}

/* The surface that feature a of a design makes; the design stays the caller's. */
static const batten_surface *surface_of(const batten_design *design)
{
    const batten_model *model = batten_design_result(design, "a")->value;
    CHECK_INT(batten_model_count(model), 1);
    const batten_object *object = batten_model_object(model, 0);
    CHECK_INT(object->kind, BATTEN_OBJECT_SURFACE);
    return object->surface;
}

static bool has_note(const batten_notes *notes, const char *words)
{
    for (int i = 0; i < batten_notes_count(notes); i++)
        if (strstr(batten_notes_at(notes, i)->text, words))
            return true;
    return false;
}

#define SADDLE                                                                             \
    "batten: 1\nfeatures:\n"                                                               \
    "  s: {line: [[0, 0, 0], [1, 0, 0]]}\n  e: {line: [[1, 0, 0], [1, 1, 1]]}\n"           \
    "  n: {line: [[0, 1, 0], [1, 1, 1]]}\n  w: {line: [[0, 0, 0], [0, 1, 0]]}\n"           \
    "  n2: {line: [[0, 1, 0.5], [1, 1, 1]]}\n"                                             \
    "  e1: {line: [[1, 0, 0], [1, 0.5, 0.5]]}\n  e2: {line: [[1, 1, 1], [1, 0.5, 0.5]]}\n" \
    "  p0: {points: [[0, 1], [1, 0]]}\n  f0: {b-spline: p0, degree: 1}\n"                  \
    "  p1: {points: [[0, 0], [1, 1]]}\n  f1: {b-spline: p1, degree: 1}\n"                  \
    "  p2: {points: [[0, 0], [1, 0.5]]}\n  f2: {b-spline: p2, degree: 1}\n"

static double height_at(const char *feature, double u, double v)
{
    char text[2000];
    batten_design *design = NULL;
    double out[3];
    snprintf(text, sizeof text, "%s  a: %s\n", SADDLE, feature);
    CHECK_OK(evaluate(text, NULL, &design));
    CHECK_OK(batten_surface_evaluate(surface_of(design), u, v, 0, out));
    batten_design_free(design);
    return out[2];
}

TEST(a_coons_patch_is_made_of_four_curves_in_any_order)
{
    CHECK_NEAR(height_at("{coons: [s, e, n, w]}", 0.25, 0.5), 0.125, 1e-15);
    CHECK_NEAR(height_at("{coons: [s, n, w, e]}", 0.25, 0.5), 0.125, 1e-15);
    CHECK_NEAR(height_at("{coons: [s, e1, n, w, e2], sides: [1, 2, 1, 1]}", 0.25, 0.5), 0.125,
               1e-15);
    const double f = 0.25 - 0.0625 * (3 - 0.5), g = 0.75 - 0.5625 * (3 - 1.5);
    CHECK_NEAR(height_at("{coons: [s, e, n, w], blend: cubic}", 0.25, 0.75), 0.1875 - f * g,
               1e-15);
    CHECK_NEAR(height_at("{coons: [s, e, n, w], kind: twists}", 0.25, 0.75), 0.1875, 1e-15);
    CHECK_NEAR(height_at("{coons: [s, e, n, w], kind: twists, twists: origin}", 0.25, 0.75),
               0.1875 - f * g, 1e-15);
    CHECK_NEAR(height_at("{coons: [s, e, n, w], kind: third}", 0.25, 0.75), 0.1875, 1e-15);
    CHECK_NEAR(height_at("{coons: [s, e, n, w], functions: [f0, f1]}", 0.25, 0.5), 0.125,
               1e-15);
    CHECK_NEAR(height_at("{coons: [s, e, n, w], blend: cubic, blend-v: linear}", 0.25, 0.75),
               0.1875, 1e-15);
}

TEST(what_a_coons_patch_cannot_use_is_said)
{
    static const char *const rows[][2] = {
        {"{coons: [s, e, n2, w]}", "corner 4, between curves 3 and 4, is open by 0.5"},
        {"{coons: [s, e, n, w], kind: third, blend: cubic}", "no H"},
        {"{coons: [s, e1, n, w, e2]}", "the number on each side is given"},
        {"{coons: [s, e, n, w], sides: [1, 1, 2]}", "'sides' has 3 counts"},
        {"{coons: [s, e, n, w], twists: origin}", "takes no twists"},
        {"{coons: [s, e, n, w], kind: twists, twists: [[0, 0, 1], [0, 0, 2]]}",
         "2 twists, not 1 or 4"},
        {"{coons: [s, e, n, w], functions: [f0]}", "1 functions, this kind takes 2"},
        {"{coons: [s, e, n, w], functions: [f0, f2]}", "F1: the value at 1 is 0.5, not 1"},
        {"{coons: [s, e, n, w], functions: [f0, n2]}", "not a graph over its parameter"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        char text[2000];
        batten_design *design = NULL;
        snprintf(text, sizeof text, "%s  a: %s\n", SADDLE, rows[i][0]);
        batten_status status = evaluate(text, NULL, &design);
        if (test_memory_failed(status, BATTEN_BAD_ARGUMENT))
            status = evaluate(text, NULL, &design);
        CHECK(status != BATTEN_OK);
        CHECK_MESSAGE(rows[i][1]);
    }
}

/* Notes for which there was no memory count as told. */
static bool told(const batten_notes *notes, const char *words)
{
    for (int i = 0; i < batten_notes_count(notes); i++)
        if (strstr(batten_notes_at(notes, i)->text, words))
            return true;
    return batten_notes_dropped(notes) > 0;
}

/* Two surfaces and a patch between them: where the tangent planes meet, normals are one. */
TEST(a_coons_patch_along_surfaces_joins_them_smoothly)
{
    static const char design_text[] =
        "batten: 1\nunits: m\nfeatures:\n"
        "  l: {points: [[0, 0, 0], [1, -0.3, 0], [2, 0, 0.1]]}\n"
        "  m: {points: [[0, 0.3, 0.9], [1, 0.1, 1], [2, 0.3, 1]]}\n"
        "  b: {points: [[0, 2, 1.5], [1, 2.2, 1.6], [2, 2, 1.5]]}\n"
        "  t: {points: [[0, 3, 1.5], [1, 3.2, 1.7], [2, 3, 1.5]]}\n"
        "  lc: {interpolate: l}\n  mc: {interpolate: m}\n  bc: {interpolate: b}\n"
        "  tc: {interpolate: t}\n"
        "  side: {skin: [lc, mc]}\n  deck: {skin: [bc, tc]}\n"
        "  s0: {curve-of: side, u: 0}\n  d0: {curve-of: deck, u: 0}\n"
        "  s1: {curve-of: side, u: 1}\n  d1: {curve-of: deck, u: 1}\n"
        "  c0: {blend: [s0, d0], first: G1, second: G1}\n"
        "  c1: {blend: [s1, d1], first: G1, second: G1}\n"
        "  far: {move: side, by: [0, 0, 9]}\n"
        "  a: {coons: [mc, c1, bc, c0], along: [side, deck]}\n";
    batten_design *design = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(20, &notes));
    CHECK_OK(evaluate(design_text, notes, &design));
    const batten_surface *patch = surface_of(design);
    const batten_surface *side =
        batten_model_object(batten_design_result(design, "side")->value, 0)->surface;
    const batten_surface *deck =
        batten_model_object(batten_design_result(design, "deck")->value, 0)->surface;
    for (int i = 0; i <= 20; i++) {
        batten_vec3 n, m;
        const double u = i / 20.0;
        for (int k = 0; k < 2; k++) {
            CHECK_OK(batten_surface_normal(patch, u, k, NULL, &n));
            CHECK_OK(batten_surface_normal(k ? deck : side, u, k ? 0 : 1, NULL, &m));
            CHECK_NEAR(fabs(n.x * m.x + n.y * m.y + n.z * m.z), 1, 1e-9);
        }
    }
    CHECK(told(notes, "side 3 lies along 'deck'"));
    batten_notes_free(notes);
    batten_design_free(design);
    char text[2000];
    snprintf(text, sizeof text, "%.*s[side, far]}\n",
             (int)(strstr(design_text, "[side, deck]}") - design_text), design_text);
    batten_status status = evaluate(text, NULL, &design);
    if (test_memory_failed(status, BATTEN_NOT_FOUND))
        status = evaluate(text, NULL, &design);
    CHECK(status != BATTEN_OK);
    CHECK_MESSAGE("'far' has no edge along a side of the patch");
}

#define NET                                                                                 \
    "batten: 1\nfeatures:\n"                                                                \
    "  g:\n    points: [[0, 0, 0], [1, 0, 0], [2, 0, 0.5], [0, 1, 0], [1, 1, 0.4], [2, 1, " \
    "0], [0, 2, 0], [1, 2, 0], [2, 2, -0.2]]\n    columns: 3\n"                             \
    "  u0: {line: [[0, 0, 0], [2, 0, 0]]}\n  u1: {line: [[0, 1, 1], [2, 1, 1]]}\n"          \
    "  v0: {line: [[0, 0, 0], [0, 1, 1]]}\n  v1: {line: [[2, 0, 0], [2, 1, 1]]}\n"          \
    "  v2: {line: [[2, 0, 0], [2, 1, 1.25]]}\n"

TEST(networks_and_corner_nets_are_made_of_points_and_curves)
{
    static const char *const features[] = {
        "{coons-network: g}",
        "{coons-network: g, blend: cubic, twists: energy, ends: natural}",
        "{coons-network: g, twists: selesnick, blend: quintic, parameters: chord}",
        "{coons-network: [u0, u1], across: [v0, v1]}",
        "{coons-network: [u0, u1], across: [v0, v1], at-u: [3, 5], at-v: [-1, 1]}",
        "{corner-net: g, tangents-u: [1, 0, 0], tangents-v: [0, 1, 0]}",
        "{corner-net: g, tangents-u: [1, 0, 0], tangents-v: [0, 1, 0], estimate: adini}",
        "{corner-net: g, twists: [0, 0, 1]}"};
    for (int i = 0; i < COUNT(features); i++) {
        char text[2000];
        batten_design *design = NULL;
        snprintf(text, sizeof text, "%s  a: %s\n", NET, features[i]);
        CHECK_OK(evaluate(text, NULL, &design));
        const batten_surface *surface = surface_of(design);
        const batten_interval u = batten_surface_domain(surface, BATTEN_U);
        const batten_interval v = batten_surface_domain(surface, BATTEN_V);
        double out[3];
        CHECK_OK(batten_surface_evaluate(surface, u.b, v.a, 0, out));
        CHECK_NEAR(out[0], 2, 1e-14);
        CHECK_NEAR(out[1], 0, 1e-14);
        batten_design_free(design);
    }
    static const char *const wrong[][2] = {
        {"{coons-network: [u0, u1], across: [v0, v2]}", "miss each other by 0.25"},
        {"{coons-network: [u0, u1], across: [v0, v1], at-u: [0, 1, 2]}", "3 values for 2"},
        {"{coons-network: u0, across: [v0, v1]}", "too small"},
        {"{corner-net: g, twists: [[0, 0, 1], [0, 0, 2]]}", "2 vectors for 9 corners"}};
    for (int i = 0; i < COUNT(wrong); i++) {
        char text[2000];
        batten_design *design = NULL;
        snprintf(text, sizeof text, "%s  a: %s\n", NET, wrong[i][0]);
        batten_status status = evaluate(text, NULL, &design);
        if (test_memory_failed(status, BATTEN_BAD_ARGUMENT))
            status = evaluate(text, NULL, &design);
        CHECK(status != BATTEN_OK);
        CHECK_MESSAGE(wrong[i][1]);
    }
}

TEST(a_coons_patch_says_what_it_reversed_and_where_its_sides_have_corners)
{
    static const char text[] =
        "batten: 1\nfeatures:\n"
        "  sp: {points: [[0, 0, 0], [0, 0, 0], [0, 0, 0], [1, 0.5, 0], [1, 0.5, 0], [1, 0.5, "
        "0], "
        "[2, 0, 0], [2, 0, 0], [2, 0, 0]]}\n"
        "  np: {points: [[0, 2, 0], [0, 2, 0], [0, 2, 0], [1, 2.5, 0], [1, 2.5, 0], [1, 2.5, "
        "0], "
        "[2, 2, 0], [2, 2, 0], [2, 2, 0]]}\n"
        "  s: {b-spline: sp, ends: free}\n  n: {b-spline: np, ends: free}\n"
        "  w: {line: [[0, 0, 0], [0, 2, 0]]}\n  e: {line: [[2, 0, 0], [2, 2, 0]]}\n"
        "  a: {coons: [s, e, n, w], blend: coons}\n";
    batten_design *design = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(20, &notes));
    CHECK_OK(evaluate(text, notes, &design));
    CHECK(told(notes, "'n' runs against the first curve"));
    CHECK(told(notes, "'w' runs against the first curve"));
    CHECK(told(notes, "side 1 stands still at 0.5"));
    CHECK(told(notes, "corners of sides 1 and 3 at 0.5"));
    batten_notes_free(notes);
    batten_design_free(design);
}

/* A patch on from a sloping strip, whose other boundary curves leave level. */
#define SLOPING                                                                  \
    "batten: 1\nfeatures:\n"                                                     \
    "  s: {line: [[0, 0, 0], [1, 0, 0]]}\n  e: {line: [[1, 0, 0], [1, 1, 0]]}\n" \
    "  n: {line: [[0, 1, 0], [1, 1, 0]]}\n  w: {line: [[0, 0, 0], [0, 1, 0]]}\n" \
    "  strip: {extrude: s, along: [0, -1, -1]}\n"

TEST(a_boundary_curve_that_leaves_the_tangent_plane_comes_with_advice)
{
    batten_design *design = NULL;
    CHECK_STATUS(evaluate(SLOPING "  a: {coons: [s, e, n, w], along: strip}\n", NULL, &design),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("the curve leaves the tangent plane at 45 degrees");
    CHECK_MESSAGE("('curve-of' and 'blend' with G1), or correct the slopes ('repair: yes')");
}

TEST(a_curve_in_the_tangent_plane_that_curvatures_do_not_fit_comes_with_other_advice)
{
    batten_design *design = NULL;
    /* 'w' leaves aslant of the curves across the strip. */
    CHECK_STATUS(
        evaluate(
            "batten: 1\nfeatures:\n"
            "  s: {line: [[0, 0, 0], [1, 0, 0]]}\n  e: {line: [[1, 0, 0], [1, 1, 0]]}\n"
            "  n: {line: [[0.5, 1, 0], [1, 1, 0]]}\n  w: {line: [[0, 0, 0], [0.5, 1, 0]]}\n"
            "  strip: {extrude: s, along: [0, -1, 0]}\n"
            "  a: {coons: [s, e, n, w], along: strip, kind: third}\n",
            NULL, &design),
        BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("slope and boundary curve differ by 0.5 per unit");
    CHECK_MESSAGE("with curvatures a slope is taken over with one factor");
}

TEST(a_repair_says_by_how_many_degrees_it_misses_the_neighbour)
{
    batten_notes *notes = NULL;
    batten_design *design = NULL;
    CHECK_OK(batten_notes_create(100, &notes));
    CHECK_OK(evaluate(SLOPING "  a: {coons: [s, e, n, w], along: strip, repair: yes}\n", notes,
                      &design));
    /* Level in both corners of the strip, which rises by 45 degrees. */
    if (batten_notes_dropped(notes) == 0)
        CHECK(has_note(notes, "up to 45 degrees off the tangent planes along the first side"));
    CHECK(!has_note(notes, "are kept to"));
    batten_notes_free(notes);
    batten_design_free(design);
}

TEST(an_angle_that_is_asked_for_is_met_by_the_given_planes_or_refused)
{
    /* The arc leaves the plane by 0.02 degrees, whose slope differs by less than the tolerance of 1 cm. */
    static const char text[] =
        "batten: 1\nunits: m\nfeatures:\n"
        "  s: {line: [[0, 0, 0], [1, 0, 0]]}\n  e: {line: [[1, 0, 0], [1, 1, 0.00035]]}\n"
        "  n: {line: [[0, 1, 0], [1, 1, 0.00035]]}\n  w: {line: [[0, 0, 0], [0, 1, 0]]}\n"
        "  strip: {extrude: s, along: [0, -1, 0]}\n"
        "  a: {coons: [s, e, n, w], along: strip, within: 1 cm%s}\n";
    static const char *const more[] = {"", ", angle: 0.03 deg", ", angle: 0.01 deg"};
    static const char *const words[] = {"up to 0.0201 degrees off", "kept to 0.02 degrees",
                                        "up to 0.0201 degrees off the tangent planes"};
    for (int i = 0; i < COUNT(more); i++) {
        char given[2000];
        batten_notes *notes = NULL;
        batten_design *design = NULL;
        CHECK_OK(batten_notes_create(100, &notes));
        snprintf(given, sizeof given, text, more[i]);
        CHECK_STATUS(evaluate(given, notes, &design),
                     i < 2 ? BATTEN_OK : BATTEN_TOLERANCE_NOT_MET);
        if (i == 2)
            CHECK_MESSAGE(words[i]);
        else
            CHECK(batten_notes_dropped(notes) > 0 || has_note(notes, words[i]));
        batten_notes_free(notes);
        batten_design_free(design);
    }
}

TEST(a_patch_of_the_third_kind_says_how_far_curvatures_are_off)
{
    /* Straight sides that leave a tube of radius 1 along its tangent plane. */
    static const char text[] =
        "batten: 1\nunits: m\nfeatures:\n"
        "  arc: {arc: 1 m, angle: 90 deg, axis: y, from: x}\n"
        "  tube: {extrude: arc, along: [0, 1, 0]}\n"
        "  s: {line: [[1, 0, 0], [1, 1, 0]]}\n  w: {line: [[1, 0, 0], [1, 0, 1]]}\n"
        "  e: {move: w, by: [0, 1, 0]}\n  n: {move: s, by: [0, 0, 1]}\n"
        "  a: {coons: [s, e, n, w], along: tube, kind: third, repair: yes}\n";
    batten_notes *notes = NULL;
    batten_design *design = NULL;
    CHECK_OK(batten_notes_create(100, &notes));
    CHECK_OK(evaluate(text, notes, &design));
    CHECK(batten_notes_dropped(notes) > 0 ||
          has_note(notes, "curvatures across the edges differ by up to 1 per unit of length"));
    batten_notes_free(notes);
    batten_design_free(design);
}

/* Sides and inward slopes of (u, v, (1 + u^3)(v + v^2)), which is cubic in u. */
#define CUBIC                                                                               \
    "batten: 1\nfeatures:\n"                                                                \
    "  ps: {points: [[0, 0, 0], [1, 0, 0]]}\n  s: {bezier: ps}\n"                           \
    "  pe: {points: [[1, 0, 0], [1, 0.5, 1], [1, 1, 4]]}\n  e: {bezier: pe}\n"              \
    "  pn: {points: [[1, 1, 4], [0.66666666666666663, 1, 2], [0.33333333333333331, 1, 2], " \
    "[0, 1, 2]]}\n  n: {bezier: pn}\n"                                                      \
    "  pw: {points: [[0, 0, 0], [0, 0.5, 0.5], [0, 1, 2]]}\n  w: {bezier: pw}\n"            \
    "  ss: {points: [[0, 1, 1], [0, 1, 1], [0, 1, 1], [0, 1, 2]]}\n"                        \
    "  se: {points: [[-1, 0, 0], [-1, 0, -1.5], [-1, 0, -6]]}\n"                            \
    "  sn: {points: [[0, -1, -6], [0, -1, -3], [0, -1, -3], [0, -1, -3]]}\n"                \
    "  sw: {points: [[1, 0, 0], [1, 0, 0]]}\n"                                              \
    "  ds: {bezier: ss}\n  de: {bezier: se}\n  dn: {bezier: sn}\n  dw: {bezier: sw}\n"

TEST(given_slopes_belong_to_the_curves_in_their_order_and_direction)
{
    static const char *const rows[] = {
        "{coons: [s, e, n, w], slopes: [ds, de, dn, dw]}",
        "{coons: [s, n, w, e], slopes: [ds, dn, dw, de]}",
        "{coons: [s, e, n, w], slopes: [ds, de, dn, dw], kind: twists}"};
    for (int i = 0; i < 3; i++) {
        char text[2000];
        batten_design *design = NULL;
        snprintf(text, sizeof text, "%s  a: %s\n", CUBIC, rows[i]);
        CHECK_OK(evaluate(text, NULL, &design));
        for (int k = 0; k < 25; k++) {
            const double u = 0.25 * (k % 5), v = 0.25 * (k / 5);
            double out[3];
            CHECK_OK(batten_surface_evaluate(surface_of(design), u, v, 0, out));
            CHECK_NEAR(out[0], u, 1e-15);
            CHECK_NEAR(out[1], v, 1e-15);
            CHECK_NEAR(out[2], (1 + u * u * u) * (v + v * v), 5e-15);
        }
        batten_design_free(design);
    }
}

TEST(a_slope_along_one_side_alone_leaves_the_others_free)
{
    char text[2000];
    batten_design *design = NULL;
    double out[9];
    snprintf(text, sizeof text, "%s  a: {coons: [n, e, s, w], slopes: dn}\n", CUBIC);
    CHECK_OK(evaluate(text, NULL, &design));
    /* The patch begins with n, from (1, 1, 4): there v runs down. */
    CHECK_OK(batten_surface_evaluate(surface_of(design), 0.5, 0, 1, out));
    CHECK_NEAR(out[6], 0, 1e-15);
    CHECK_NEAR(out[7], -1, 1e-15);
    CHECK_NEAR(out[8], -3 * (1 + 0.125), 1e-14);
    batten_design_free(design);
}

TEST(slopes_that_a_patch_cannot_use_are_refused)
{
    static const char *const rows[][2] = {
        {"{coons: [s, e, n, w], slopes: ds, kind: first}", "takes no 'slopes'"},
        {"{coons: [s, e, n, w], slopes: [ds, de, dn, dw, ds]}",
         "there are 5 'slopes' for 4 curves"},
        {"{coons: [s, e, n, w], slopes: ds, along: b}", "'along' and 'slopes' both say"},
        {"{coons: [s, e, n1, n2, w], sides: [1, 1, 2, 1], slopes: [ds, de, dn]}",
         "'dn' is the slope of curve 3, which shares its side"},
        {"{coons: [s, e, n, w], slopes: [de]}", "slope"}};
    for (int i = 0; i < 5; i++) {
        char text[2500];
        batten_design *design = NULL;
        snprintf(text, sizeof text,
                 "%s  b: {extrude: s, along: [0, -1, 0]}\n  n1: {trim: n, between: [0, 0.5]}\n"
                 "  n2: {trim: n, between: [0.5, 1]}\n  a: %s\n",
                 CUBIC, rows[i][0]);
        CHECK_STATUS(evaluate(text, NULL, &design),
                     i < 4 ? BATTEN_BAD_ARGUMENT : BATTEN_NOT_COMPATIBLE);
        CHECK_CONTAINS(batten_message(), rows[i][1]);
        batten_design_free(design);
    }
}
