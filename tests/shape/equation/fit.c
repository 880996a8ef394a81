/* Cubics along pieces of implicit curves. */
#include "shape/equation/fit.h"

#include "systems.h"

static batten_status fit_alone(bat_system *system, double tolerance, const bat_segment *of,
                               int count, bat_segments *branch, double *error)
{
    *branch = (bat_segments){bat_array((size_t)count, sizeof *of), count, count};
    if (!branch->items)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(branch->items, of, (size_t)count * sizeof *of);
    const batten_status status = bat_segments_fit(system, tolerance, branch, error);
    if (status != BATTEN_OK)
        bat_release(branch->items);
    return status;
}

/* y = q(x) = x^4 - 2 x^2 + 2 x from 0 to 1 has the slope 2 at both ends; with these tangents x is linear in
 * the cubic's parameter, so that y misses by t^2 (1 - t)^2, at most 1/16. */
static const bat_segment quartic = {.to = {1, 1, 1},
                                    .leave = {0.7071067811865476, 1.4142135623730951},
                                    .arrive = {0.7071067811865476, 1.4142135623730951},
                                    .cell = {{{0, 1}, {-1, 2}, {-1, 2}}}};

TEST(the_distance_of_a_cubic_is_proved_by_the_fourth_derivative)
{
    static const char *const texts[] = {"y - (x^4 - 2*x^2 + 2*x)", "3*(x^4 - 2*x^2 + 2*x - y)"};
    for (int i = 0; i < COUNT(texts); i++) {
        test_system s;
        bat_segments branch = {NULL, 0, 0};
        double error = 0;
        begin_test_system(&s, texts[i], NULL);
        CHECK_OK(fit_alone(&s.system, 0.07, &quartic, 1, &branch, &error));
        CHECK_INT(branch.count, 1);
        CHECK_NEAR(error, 1.0 / 16, 1e-13);
        bat_release(branch.items);
        CHECK_OK(fit_alone(&s.system, 0.06, &quartic, 1, &branch, &error));
        CHECK(branch.count >= 2 && error >= 1.0 / 16); /* the larger one remains */
        bat_release(branch.items);
        end_test_system(&s);
    }
}

/* In space y = z = q(x), with chords of length sqrt 3. */
TEST(the_distance_in_space_counts_both_equations)
{
    static const char *const texts[][2] = {
        {"y - (x^4 - 2*x^2 + 2*x)", "z - (x^4 - 2*x^2 + 2*x)"},
        {"y - (x^4 - 2*x^2 + 2*x)", "z - y"},
        {"y - z", "y + z - 2*(x^4 - 2*x^2 + 2*x)"},
    };
    const double third = 0.5773502691896258;
    bat_segment segment = quartic;
    for (int k = 0; k < 3; k++)
        segment.leave[k] = segment.arrive[k] = k ? 2 * third : third;
    for (int i = 0; i < COUNT(texts); i++) {
        test_system s;
        bat_segments branch = {NULL, 0, 0};
        double error = 0;
        begin_test_system(&s, texts[i][0], texts[i][1]);
        CHECK_OK(fit_alone(&s.system, 1, &segment, 1, &branch, &error));
        CHECK_NEAR(error, sqrt(2) / 16, 1e-13);
        bat_release(branch.items);
        end_test_system(&s);
    }
}

/* Of a unit circle from angle a to angle b, counter-clockwise. */
static bat_segment arc_of(double a, double b, int graph)
{
    const double xa = cos(a), ya = sin(a), xb = cos(b), yb = sin(b);
    return (bat_segment){.from = {xa, ya},
                         .to = {xb, yb},
                         .leave = {-ya, xa},
                         .arrive = {-yb, xb},
                         .cell = {{{fmin(xa, xb), a < 0 && b > 0 ? 1 : fmax(xa, xb)},
                                   {fmin(ya, yb), fmax(ya, yb)}}},
                         .graph = graph};
}

TEST(segments_of_a_circle_are_divided_and_joined_until_the_error_is_proved)
{
    static const double tolerances[] = {1e-2, 1e-3, 1e-6, 1e-9};
    test_system s;
    begin_test_system(&s, "x^2 + y^2 - 1", NULL);
    for (int i = 0; i < COUNT(tolerances); i++) {
        const bat_segment arcs[] = {arc_of(-1.2, -0.4, 1), arc_of(-0.4, 0.3, 1),
                                    arc_of(0.3, 1.2, 1)};
        bat_segments branch = {NULL, 0, 0};
        batten_curve *curve = NULL;
        double error = 0, worst = 0;
        CHECK_OK(fit_alone(&s.system, tolerances[i], arcs, COUNT(arcs), &branch, &error));
        for (int k = 1; k < branch.count; k++)
            for (int c = 0; c < 2; c++)
                CHECK(branch.items[k].from[c] == branch.items[k - 1].to[c]);
        CHECK_OK(bat_segments_curve(2, &branch, &curve));
        const batten_interval domain = batten_curve_domain(curve);
        CHECK_NEAR(domain.b, 2.4, 1e-12); /* arcs of a circle have their lengths */
        for (int k = 0; k <= 500; k++) {
            double p[2];
            CHECK_OK(batten_curve_evaluate(curve, fmin(domain.b * k / 500, domain.b), 0, p));
            worst = fmax(worst, fabs(hypot(p[0], p[1]) - 1));
        }
        CHECK(worst <= error && error <= tolerances[i]);
        batten_curve_unref(curve);
        bat_release(branch.items);
    }
    end_test_system(&s);
}

TEST(a_tolerance_below_rounding_is_not_met_and_the_message_says_where)
{
    test_system s;
    bat_segments branch = {NULL, 0, 0};
    double error = 0;
    const bat_segment arc = arc_of(-0.5, 0.5, 1);
    begin_test_system(&s, "x^2 + y^2 - 1", NULL);
    CHECK_STATUS(fit_alone(&s.system, 1e-16, &arc, 1, &branch, &error),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("near (0.877583, -0.479426, 0) rounding does not allow a distance of 1e-16");
    end_test_system(&s);
}

TEST(lines_and_links_are_kept_and_corners_count_with_their_cells)
{
    test_system s;
    bat_segments branch = {NULL, 0, 0};
    double error = 0;
    const bat_segment pieces[] = {
        {.to = {0.5, 0}, .is_link = true, .is_line = true},
        {.from = {0.5, 0}, .to = {1, 1}, .is_link = true, .leave = {1, 0}, .arrive = {0, 1}},
        {.from = {-3, 3},
         .to = {4, 4},
         .leave = {1, -1},
         .arrive = {1, 1},
         .cell = {{{-3, 4}, {0, 4}}}},
    };
    begin_test_system(&s, "y - abs(x)", NULL);
    CHECK_OK(fit_alone(&s.system, 9, pieces, 3, &branch, &error));
    CHECK_INT(branch.count, 3);
    CHECK(!branch.items[0].has_corner && !branch.items[1].has_corner);
    CHECK(branch.items[2].has_corner && branch.items[2].is_line && branch.items[2].is_link);
    CHECK_NEAR(error, sqrt(65), 1e-14);
    bat_release(branch.items);
    end_test_system(&s);
}

TEST(a_closed_branch_has_no_extent_and_an_open_one_that_of_its_chords)
{
    test_system s;
    bat_segment chords[] = {{.from = {1, 2, 3}, .to = {4, 6, 3}},
                            {.from = {4, 6, 3}, .to = {4, 6, 7}}};
    begin_test_system(&s, "x", "y");
    const bat_segments both = {chords, 2, 2}, first = {chords, 1, 2};
    CHECK(bat_segments_extent(&s.system, &both) == 9);
    CHECK(bat_segments_extent(&s.system, &first) == 5);
    memcpy(chords[1].to, chords[0].from, sizeof chords[0].from);
    CHECK(bat_segments_extent(&s.system, &both) == (double)INFINITY);
    end_test_system(&s);
}

/* A quarter of a circle has legs of a third of its length, pi / 6; a line's are thirds of it. */
TEST(cubics_share_their_tangents_where_they_have_one_and_their_points_elsewhere)
{
    const double leg = 0.5235987755982988;
    const bat_segment pieces[] = {
        {.from = {1, 0}, .to = {0, 1}, .leave = {0, 1}, .arrive = {-1, 0}},
        {.from = {0, 1}, .to = {-1, 0}, .leave = {-1, 0}, .arrive = {0, -1}},
        {.from = {-1, 0}, .to = {-1, -3}, .leave = {0, -1}, .arrive = {0, -1}, .is_line = true},
        {.from = {-1, -3}, .to = {2, -3}, .leave = {1, 0}, .arrive = {1, 0}},
        {.from = {2, -3}, .to = {2, 0}, .leave = {0, 1}, .arrive = {0, 1}},
    };
    const double points[][2] = {
        {1, 0},   {1, leg}, {leg, 1}, {-leg, 1}, {-1, leg}, {-1, 0}, {-1, -1}, {-1, -2},
        {-1, -3}, {0, -3},  {1, -3},  {2, -3},   {2, -2},   {2, -1}, {2, 0},
    };
    const double half = 1.5707963267948966;
    const double knots[] = {0,
                            0,
                            0,
                            0,
                            half,
                            half,
                            2 * half,
                            2 * half,
                            2 * half,
                            2 * half + 3,
                            2 * half + 3,
                            2 * half + 3,
                            2 * half + 6,
                            2 * half + 6,
                            2 * half + 6,
                            2 * half + 9,
                            2 * half + 9,
                            2 * half + 9,
                            2 * half + 9};
    batten_curve *curve = NULL;
    bat_segment copies[COUNT(pieces)];
    memcpy(copies, pieces, sizeof pieces);
    CHECK_OK(bat_segments_curve(2, &(bat_segments){copies, COUNT(pieces), 0}, &curve));
    CHECK_INT(batten_curve_degree(curve), 3);
    CHECK_INT(batten_curve_point_count(curve), COUNT(points));
    for (int i = 0; i < 2 * COUNT(points); i++)
        CHECK_NEAR(batten_curve_points(curve)[i], points[i / 2][i % 2], 1e-14);
    for (int i = 0; i < COUNT(knots); i++)
        CHECK_NEAR(batten_curve_knots(curve)[i], knots[i], 1e-14);
    batten_curve_unref(curve);
}

TEST(the_tangent_of_a_segment_has_the_sense_along_the_axis_that_is_asked_for)
{
    static const struct {
        int graph;
        double sense, tangent[2];
    } rows[] = {
        {0, 1, {0.8, -0.6}}, {0, -1, {-0.8, 0.6}}, {1, 1, {-0.8, 0.6}}, {1, -1, {0.8, -0.6}}};
    test_system s;
    const double at[] = {0.6, 0.8};
    for (int i = 0; i < 2 * COUNT(rows); i++) {
        double out[3];
        begin_test_system(&s, i % 2 ? "1 - x^2 - y^2" : "x^2 + y^2 - 1", NULL);
        bat_segment_tangent(&s.system, at, rows[i / 2].graph, rows[i / 2].sense, out);
        CHECK_NEAR(out[0], rows[i / 2].tangent[0], 1e-15);
        CHECK_NEAR(out[1], rows[i / 2].tangent[1], 1e-15);
        end_test_system(&s);
    }
}

TEST(the_cell_of_a_segment_shrinks_to_what_lies_between_its_ends)
{
    static const int senses[] = {1, -1};
    test_system s;
    begin_test_system(&s, "x^2 + y^2 - 1", NULL);
    for (int i = 0; i < COUNT(senses); i++) {
        bat_segment arc = arc_of(-0.25 * senses[i], 0.25 * senses[i], 1);
        arc.cell = (bat_cell){{{0.5, 2}, {-0.5, 0.5}}};
        bat_segment_tighten(&s.system, &arc);
        CHECK_NEAR(arc.cell.at[1].lo, -sin(0.25), 1e-15);
        CHECK_NEAR(arc.cell.at[1].hi, sin(0.25), 1e-15);
        CHECK(arc.cell.at[0].lo <= cos(0.25) && arc.cell.at[0].lo > 0.92);
        CHECK(arc.cell.at[0].hi >= 1 && arc.cell.at[0].hi < 1.08);
        arc.cell = (bat_cell){{{1.5, 2}, {-0.5, 0.5}}}; /* the curve is not in it */
        bat_segment_tighten(&s.system, &arc);
        CHECK(arc.cell.at[0].lo == 1.5 && arc.cell.at[0].hi == 2);
        CHECK_NEAR(arc.cell.at[1].hi, sin(0.25), 1e-15);
    }
    end_test_system(&s);
}
