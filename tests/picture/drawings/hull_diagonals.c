/* Diagonals lie in the planes that were asked for, or cross the section amidships squarely. */
#include "picture/drawings/hull.h"

#include "picture/scenes.h"

static const double L = 10, B = 2, T = 1;

/* As the Wigley hull is written down. */
static double breadth(double x, double z)
{
    const double X = 2 * x / L, Z = z / T;
    return 0.5 * B * (1 - X * X) * (1 - Z * Z);
}

static void check_diagonal(const bat_cut *cut)
{
    CHECK(cut->lines.count > 0);
    for (size_t k = 0; k < cut->lines.count; k++)
        for (size_t n = 0; n < cut->lines.strokes[k].count; n++) {
            const double *p = cut->lines.strokes[k].points + 3 * n;
            CHECK_NEAR(p[2], cut->at - p[1] * tan(cut->angle), 1e-6);
            CHECK_NEAR(p[1], breadth(p[0], p[2]), 1e-5);
            CHECK_NEAR(bat_diagonal_way(cut, p), hypot(p[1], cut->at - p[2]), 1e-6);
        }
}

TEST(given_diagonals_lie_in_their_planes_on_either_side)
{
    static const double at[] = {-0.1, 0.5, 0}, angle[] = {0.3, 1.2, 0.7};
    static const double sides[] = {1, -1};
    for (int s = 0; s < test_cases(COUNT(sides)); s++) {
        batten_model *model = scene_of(scene_wigley(L, B, T, sides[s]));
        batten_draw_lines_plan_options plan = scene_plan(L);
        plan.diagonal_at = at;
        plan.diagonal_angle = angle;
        plan.diagonal_count = COUNT(at);
        bat_hull hull;
        CHECK_OK(bat_hull_cut(model, &plan, NULL, &hull));
        const bat_cuts *cuts = &hull.families[BAT_DIAGONALS];
        CHECK_INT(cuts->count, COUNT(at));
        for (int i = 0; i < cuts->count; i++) {
            CHECK_BITS(cuts->cuts[i].at, at[i]);
            CHECK_BITS(cuts->cuts[i].angle, angle[i]);
            check_diagonal(&cuts->cuts[i]);
        }
        bat_hull_free(&hull);
        batten_model_unref(model);
    }
}

/* A trough of radius 2 whose axis is the line y = z = 0: all normals of its sections go through the axis. */
static batten_surface *trough(void)
{
    enum { ROWS = 2, COLUMNS = 33 };
    double points[ROWS * COLUMNS * 3];
    for (int i = 0; i < ROWS; i++)
        for (int k = 0; k < COLUMNS; k++) {
            double *p = points + 3 * (i * COLUMNS + k);
            const double fall = 0.5 * BAT_PI * k / (COLUMNS - 1);
            p[0] = 10 * i;
            p[1] = 2 * cos(fall);
            p[2] = -2 * sin(fall);
        }
    return scene_net(1, ROWS, 1, COLUMNS, points);
}

TEST(chosen_diagonals_cross_a_round_section_at_equal_angles_and_squarely)
{
    static const double three[] = {65, 45, 20}, one[] = {45};
    static const struct {
        int asked, count;
        const double *angles; /* whole five degrees of 67.5, 45, 22.5 */
    } rows[] = {{-1, 3, three}, {3, 3, three}, {1, 1, one}, {0, 0, NULL}};
    batten_model *model = scene_of(trough());
    for (int i = 0; i < test_cases(COUNT(rows)); i++) {
        batten_draw_lines_plan_options plan = scene_plan(L);
        plan.diagonals = rows[i].asked;
        bat_hull hull;
        CHECK_OK(bat_hull_cut(model, &plan, NULL, &hull));
        const bat_cuts *cuts = &hull.families[BAT_DIAGONALS];
        CHECK_INT(cuts->count, rows[i].count);
        for (int k = 0; k < cuts->count; k++) {
            CHECK_NEAR(cuts->cuts[k].angle * 180 / BAT_PI, rows[i].angles[k], 1e-9);
            /* From the axis or below, for the angle was rounded down; to a fiftieth of the depth. */
            CHECK(cuts->cuts[k].at < 0.051 && cuts->cuts[k].at > -0.25);
            CHECK_NEAR(cuts->cuts[k].at / 0.05, round(cuts->cuts[k].at / 0.05), 1e-9);
        }
        CHECK((hull.reach > 1.8) == (cuts->count > 0));
        bat_hull_free(&hull);
    }
    batten_model_unref(model);
}

TEST(diagonals_that_make_no_sense_are_refused)
{
    static const double heights[] = {0, 0.2, NAN};
    static const double angles[] = {0.5, 0.5 * BAT_PI, 0.5}, level[] = {0};
    static const struct {
        int chosen, count;
        const double *at, *angle;
        batten_status status;
        const char *says;
    } rows[] = {
        {-1, 2, heights, angles, BATTEN_BAD_ARGUMENT, "diagonal 2 falls by 90 degrees"},
        {-1, 1, heights, level, BATTEN_BAD_ARGUMENT, "diagonal 1 falls by 0 degrees"},
        {-1, 1, heights + 2, angles, BATTEN_NOT_FINITE, "diagonal 1"},
        {-1, 401, heights, angles, BATTEN_TOO_LARGE, "401 diagonals are"},
        {-1, -1, heights, angles, BATTEN_TOO_LARGE, "-1"},
        {500, 0, NULL, NULL, BATTEN_TOO_LARGE, "500 diagonals are"},
    };
    batten_model *model = scene_of(scene_wigley(L, B, T, 1));
    for (int i = 0; i < test_cases(COUNT(rows)); i++) {
        batten_draw_lines_plan_options plan = scene_plan(L);
        plan.diagonals = rows[i].chosen;
        plan.diagonal_at = rows[i].at;
        plan.diagonal_angle = rows[i].angle;
        plan.diagonal_count = rows[i].count;
        bat_hull hull;
        CHECK_STATUS(bat_hull_cut(model, &plan, NULL, &hull), rows[i].status);
        CHECK_MESSAGE(rows[i].says);
    }
    batten_model_unref(model);
}

TEST(a_diagonal_beside_the_hull_is_said)
{
    static const double at[] = {30}, angle[] = {0.1};
    batten_model *model = scene_of(scene_wigley(L, B, T, 1));
    batten_draw_lines_plan_options plan = scene_plan(L);
    plan.diagonal_at = at;
    plan.diagonal_angle = angle;
    plan.diagonal_count = 1;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    bat_hull hull;
    CHECK_OK(bat_hull_cut(model, &plan, notes, &hull));
    CHECK_NEAR(hull.reach, 0, 0);
    if (batten_notes_count(notes) > 0)
        CHECK_CONTAINS(batten_notes_at(notes, 0)->text,
                       "diagonal 1 from height 30 does not meet the hull");
    CHECK(batten_notes_count(notes) + batten_notes_dropped(notes) >= 1);
    bat_hull_free(&hull);
    batten_notes_free(notes);
    batten_model_unref(model);
}
