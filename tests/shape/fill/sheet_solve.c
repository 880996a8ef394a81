/* The fairest height over a hole that meets its conditions. */
#include "shape/fill/sheet.h"

#include "shape/fill/loops.h"
#include "support/faults.h"

static double corners[4][2] = {{-1, -0.25}, {1, -0.25}, {1, 0.25}, {-1, 0.25}};
static const bat_sheet_outline strip = {
    .low = {-1, -0.25}, .high = {1, 0.25}, .ring_count = 4, .ring = corners[0]};

/* A plane has no energy: three conditions of any kind are enough for it. */
static bat_sheet_condition planes[][3] = {
    {{{-0.5, 0.1}, {0, 0}, 0, -0.3, 1, 1e-12},
     {{0.7, 0.2}, {0, 0}, 0, 1.8, 1, 1e-12},
     {{0.9, -0.2}, {0, 0}, 0, 3.4, 1, 1e-12}},
    {{{0.5, 0.1}, {0, 0}, 0, 1.7, 2, 1e-12},
     {{-1, 0.25}, {1, 0}, 1, 2, 1, 1e-12},
     {{1, -0.25}, {1, 2}, 1, -4, 0.5, 1e-12}},
};

TEST(the_sheet_over_conditions_of_a_plane_is_the_plane)
{
    for (int i = 0; i < COUNT(planes); i++)
        for (int spans = 1; spans < 12; spans += 5) {
            const bat_sheet_conditions asked = {3, 3, planes[i]};
            batten_surface *sheet = NULL;
            CHECK_OK(bat_sheet_solve(&strip, &asked, spans, &sheet));
            for (int d = 0; d < 2; d++) {
                const batten_direction direction = d ? BATTEN_V : BATTEN_U;
                const batten_interval domain = batten_surface_domain(sheet, direction);
                CHECK(domain.a == strip.low[d] && domain.b == strip.high[d]);
                CHECK_INT(batten_surface_degree(sheet, direction), 5);
            }
            CHECK_INT(batten_surface_spans(sheet, BATTEN_U, NULL) - 1, spans > 2 ? spans : 2);
            CHECK_INT(batten_surface_spans(sheet, BATTEN_V, NULL) - 1,
                      spans > 8 ? (spans + 3) / 4 : 2);
            for (int k = 0; k < 36; k++) {
                const double x = -1 + 0.4 * (k % 6), y = -0.25 + 0.1 * (k / 6);
                double p[3];
                CHECK_OK(batten_surface_evaluate(sheet, fmin(1, x), fmin(0.25, y), 0, p));
                CHECK_NEAR(p[0], x, 1e-14);
                CHECK_NEAR(p[1], y, 1e-14);
                CHECK_NEAR(p[2], 1 + 2 * x - 3 * y, 1e-5);
            }
            batten_surface_unref(sheet);
        }
}

/* 1 + x + 2 y + x^2 / 2 - x y + 2 y^2 + x^2 y, and its derivative of an order along (a, b). */
static double cubic(const double at[2], const double along[2], int order)
{
    const double x = at[0], y = at[1], a = along[0], b = along[1];
    const double values[3] = {1 + x + 2 * y + x * x / 2 - x * y + 2 * y * y + x * x * y,
                              a * (1 + x - y + 2 * x * y) + b * (2 - x + 4 * y + x * x),
                              a * a * (1 + 2 * y) + 2 * a * b * (2 * x - 1) + b * b * 4};
    return values[order];
}

/* Of all orders along several directions, more than there are unknowns. */
static int ask_cubic(bat_sheet_condition *at)
{
    static const double directions[3][2] = {{1, 0}, {0.6, 0.8}, {-0.5, 1}};
    int count = 0;
    for (int i = 0; i <= 8; i++)
        for (int j = 0; j <= 8; j++, count++) {
            bat_sheet_condition *c = &at[count];
            *c = (bat_sheet_condition){.at = {-1 + i / 4.0, -0.25 + j / 16.0},
                                       .order = (i + 2 * j) % 3,
                                       .weight = 1 + i % 2,
                                       .allowed = 1e-6};
            memcpy(c->along, directions[(i + j) % 3], sizeof c->along);
            c->value = cubic(c->at, c->along, c->order);
        }
    return count;
}

TEST(conditions_of_all_orders_that_the_spline_can_meet_are_met)
{
    bat_sheet_condition at[81];
    batten_surface *sheet = NULL;
    const bat_sheet_conditions asked = {ask_cubic(at), 81, at};
    CHECK_OK(bat_sheet_solve(&strip, &asked, 2, &sheet));
    for (int k = 0; k < 81; k++) {
        double d[6][3];
        const double *along = at[k].along;
        CHECK_OK(batten_surface_evaluate(sheet, at[k].at[0], at[k].at[1], 2, d[0]));
        const double a = along[0], b = along[1];
        const double found[3] = {d[0][2], a * d[1][2] + b * d[2][2],
                                 a * a * d[3][2] + 2 * a * b * d[4][2] + b * b * d[5][2]};
        CHECK_NEAR(found[at[k].order], at[k].value, 1.01e-6);
    }
    batten_surface_unref(sheet);
}

static batten_status solve_once(const bat_sheet_conditions *asked)
{
    batten_surface *sheet = NULL;
    const batten_status status = bat_sheet_solve(&strip, asked, 1, &sheet);
    CHECK((status == BATTEN_OK) == (sheet != NULL));
    batten_surface_unref(sheet);
    return status;
}

TEST(a_sheet_reports_every_lack_of_memory)
{
    const bat_sheet_conditions asked = {3, 3, planes[0]};
    CHECK_ALL_ALLOCATIONS(solve_once(&asked));
}
