/* How far edges are from the surfaces of their faces, and knots that nearly coincide. */
#include "body/builder.h"
#include "body/check/parts.h"
#include "body/check/sheet.h"
#include "support/test.h"

#include <batten/standard.h>

/* ---- knots ---- */

/* Knots of degree 1 from 0 to 4: gaps beside a millionth of the domain, in the first, the middle and the last span. */
static const struct {
    double knots[6];
    double gap; /* share of the domain */
    bool is_close;
} knot_rows[] = {
    {{0, 0, 1, 3, 4, 4}, 0.25, false},
    {{0, 0, 2, 2 + 0x1p-18, 4, 4}, 0x1p-20, true},
    {{0, 0, 2, 2 + 0x1p-17, 4, 4}, 0x1p-19, false},
    {{0, 0, 0x1p-18, 2, 4, 4}, 0x1p-20, true},
    {{0, 0, 2, 4 - 0x1p-18, 4, 4}, 0x1p-20, true},
    {{0, 0, 0x1p-19, 2, 4, 4}, 0x1p-21, true},
};

TEST(knots_are_close_within_a_millionth_of_the_domain)
{
    static const double points[4] = {0, 1, 3, 7};
    for (int i = 0; i < COUNT(knot_rows); i++) {

        batten_curve *curve = NULL;
        bool close = !knot_rows[i].is_close;
        double gap = -1;
        CHECK_OK(batten_curve_create((batten_points){1, 4, points}, 1, NULL, knot_rows[i].knots,
                                     &curve));
        CHECK_OK(bat_check_curve_knots(curve, &close, &gap));
        CHECK_INT(close, knot_rows[i].is_close);
        CHECK_BITS(gap, knot_rows[i].gap);
        batten_curve_unref(curve);
    }
}

TEST(a_gap_of_just_a_millionth_is_not_close)
{
    static const double points[3] = {0, 1, 3};
    for (int less = 0; less < 2; less++) {
        const double knots[5] = {0, 0, less ? 0.999999e-6 : 1e-6, 1, 1};
        batten_curve *curve = NULL;
        bool close = !less;
        double gap = -1;
        CHECK_OK(batten_curve_create((batten_points){1, 3, points}, 1, NULL, knots, &curve));
        CHECK_OK(bat_check_curve_knots(curve, &close, &gap));
        CHECK_INT(close, less);
        batten_curve_unref(curve);
    }
}

TEST(a_curve_of_one_span_has_the_whole_domain_as_its_gap)
{
    static const double points[2] = {2, 5};
    batten_curve *line = NULL;
    bool close = true;
    double gap = -1;
    CHECK_OK(batten_curve_line(1, points, points + 1, &line));
    CHECK_OK(bat_check_curve_knots(line, &close, &gap));
    CHECK(!close);
    CHECK_BITS(gap, 1);
    batten_curve_unref(line);
}

/* Row k of the knots above in u with row l in v: the gap is that of the direction that is close, u first. */
TEST(knots_of_surfaces_are_looked_at_in_both_directions)
{
    static const double net[16] = {0};
    for (int k = 0; k < COUNT(knot_rows); k++)
        for (int l = 0; l < COUNT(knot_rows); l++) {
            const batten_axis u = {1, 4, knot_rows[k].knots, false},
                              v = {1, 4, knot_rows[l].knots, false};
            batten_surface *surface = NULL;
            bool close = false;
            double gap = -1;
            CHECK_OK(batten_surface_create(1, &u, &v, net, NULL, &surface));
            CHECK_OK(bat_check_surface_knots(surface, &close, &gap));
            CHECK_INT(close, knot_rows[k].is_close || knot_rows[l].is_close);
            CHECK_BITS(gap, knot_rows[knot_rows[k].is_close ? k : l].gap);
            batten_surface_unref(surface);
        }
}

/* ---- misses ---- */

/* The first edge of a square sheet, from (0, 0) to (4, 0), and its use, changed by the test. */
typedef struct {
    batten_body *sheet;
    batten_body_parts parts;
    batten_body_edge edges[4];
    batten_body_use uses[4];
} sheet_change;

static void begin_sheet(sheet_change *s)
{
    s->sheet = sheet_with_loops(0, NULL, NULL, 0);
    s->parts = *batten_body_view(s->sheet);
    CHECK_INT(s->parts.edge_count, 4);
    CHECK_INT(s->parts.use_count, 4);
    memcpy(s->edges, s->parts.edges, sizeof s->edges);
    memcpy(s->uses, s->parts.uses, sizeof s->uses);
    s->parts.edges = s->edges;
    s->parts.uses = s->uses;
}

static batten_status find_misses(const sheet_change *s, double tolerance, batten_notes *notes,
                                 batten_body_faults *faults)
{
    *faults = (batten_body_faults){.loose = 0};
    bat_check check = {.parts = &s->parts,
                       .tolerance = tolerance,
                       .notes = notes,
                       .faults = faults,
                       .named = &s->parts};
    return bat_check_misses(&check, 0);
}

static batten_body_faults misses_of(const sheet_change *s, double tolerance,
                                    batten_notes *notes)
{
    batten_body_faults faults;
    CHECK_OK(find_misses(s, tolerance, notes, &faults));
    return faults;
}

static void end_sheet(sheet_change *s)
{
    batten_body_unref(s->sheet);
}

/* z = h 4 t^3 (1 - t), which is largest at t = 3/4, in one span or in two; x runs from 0 to 4. */
static batten_curve *bump(double h, bool in_two)
{
    static const double more[] = {0.5};
    const double points[15] = {0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, h, 4, 0, 0};
    batten_curve *whole = NULL, *divided = NULL;
    double breaks[2] = {0, 1};
    CHECK_OK(batten_curve_from_bezier(3, (batten_pieces){4, 1, breaks}, points, NULL, &whole));
    if (!in_two)
        return whole;
    CHECK_OK(batten_curve_refine(whole, 1, more, &divided));
    batten_curve_unref(whole);
    return divided;
}

/* The ends and three places of each span are looked at; of a plane the nearest point is as far as the parameters say. */
TEST(an_edge_is_as_far_as_its_farthest_place)
{
    const double h = 0.01, most = h * 27 / 64;
    for (int i = 0; i < 8; i++) {
        sheet_change s;
        batten_curve *curve = bump(h, i & 1);
        begin_sheet(&s);
        s.edges[0].curve = curve;
        s.parts.is_traced = i & 2;
        const double tolerance = most * (i & 4 ? 1 - 1e-9 : 1 + 1e-9);
        const batten_body_faults faults = misses_of(&s, tolerance, NULL);
        CHECK_NEAR(faults.largest_miss, most, 1e-15);
        CHECK_INT(faults.loose, i & 4 ? 1 : 0);
        CHECK_INT(faults.close_knots, 0);
        end_sheet(&s);
        batten_curve_unref(curve);
    }
}

/* An edge of more spans than there are places: still from end to end. */
TEST(of_an_edge_with_many_spans_64_places_are_looked_at)
{
    double points[3 * 41] = {0};
    batten_curve *curve = NULL;
    sheet_change s;
    for (int i = 0; i <= 40; i++)
        points[3 * i] = 0.1 * i;
    points[3 * 40 + 2] = 0.125;
    begin_sheet(&s);
    CHECK_OK(batten_curve_polyline((batten_points){3, 41, points}, &curve));
    s.edges[0].curve = curve;
    CHECK_NEAR(misses_of(&s, 1, NULL).largest_miss, 0.125, 1e-15);
    end_sheet(&s);
    batten_curve_unref(curve);
}

/* The curve in the parameters begins late by `late`, or ends beyond the surface, whose parameters end at 6. */
TEST(edges_of_traced_bodies_are_measured_at_their_parameters)
{
    static const struct {
        double from[2], to[2], miss;
        bool is_traced;
    } cases[] = {{{0.25, 0}, {4, 0}, 0.25, true},  {{0, 0}, {4.5, 0}, 0.5, true},
                 {{0, 0.5}, {4, 0.5}, 0.5, true},  {{0, -0.5}, {4, -0.5}, 0, true},
                 {{0, 0}, {8, 0}, 3, true},        {{0, 0}, {-4, 0}, 4, true},
                 {{0.25, 0.5}, {4, 0}, 0.0, false}};
    for (int i = 0; i < COUNT(cases); i++) {
        sheet_change s;
        batten_curve *flat = NULL;
        begin_sheet(&s);
        CHECK_OK(batten_curve_line(2, cases[i].from, cases[i].to, &flat));
        s.uses[0].parameters = flat;
        s.parts.is_traced = cases[i].is_traced;
        CHECK_NEAR(misses_of(&s, 1, NULL).largest_miss, cases[i].miss, 1e-12);
        end_sheet(&s);
        batten_curve_unref(flat);
    }
}

TEST(edges_without_a_curve_miss_nothing)
{
    sheet_change s;
    begin_sheet(&s);
    for (int i = 0; i < 4; i++)
        s.edges[i].curve = NULL;
    const batten_body_faults faults = misses_of(&s, 1e-6, NULL);
    CHECK_BITS(faults.largest_miss, 0);
    CHECK_INT(faults.loose, 0);
    end_sheet(&s);
}

TEST(misses_and_knots_of_parameters_are_noted_with_the_face_the_edge_and_the_number)
{
    static const double more[] = {0.5, 0.5 + 0x1p-24};
    sheet_change s;
    batten_curve *curve = bump(0.64, false), *refined = NULL;
    batten_notes *notes = NULL;
    begin_sheet(&s);
    CHECK_OK(batten_notes_create(9, &notes));
    CHECK_OK(batten_curve_refine(s.uses[2].parameters, 2, more, &refined));
    s.edges[1].curve = s.edges[0].curve;
    s.edges[0].curve = curve;
    s.uses[2].parameters = refined;
    const batten_body_faults faults = misses_of(&s, 1e-6, notes);
    CHECK_INT(faults.loose, 2);
    CHECK_INT(faults.close_knots, 1);
    if (batten_notes_dropped(notes) == 0 && test_cases(10) >= 10) {
        static const char *const texts[] = {
            "edge 1 misses its surface by 0.27 units", "edge 2 misses its surface by 4 units",
            ("the curve of edge 3 in its parameters has knots "
             "very near each other: 5.96046e-08 of the domain")};
        CHECK_INT(batten_notes_count(notes), 3);
        for (int i = 0; i < batten_notes_count(notes); i++) {
            CHECK_TEXT(batten_notes_at(notes, i)->text, texts[i]);
            CHECK_TEXT(batten_notes_at(notes, i)->entity, "face 1 \"sheet\"");
        }
    }
    batten_notes_free(notes);
    end_sheet(&s);
    batten_curve_unref(curve);
    batten_curve_unref(refined);
}
