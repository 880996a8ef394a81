/* Contours of pieces whose evaluation is ours: a failure at any place ends them; points that are hardly isolated. */
#include "inspect/contours/contours.h"
#include "support/test.h"

/* z = a u^2 + b v^2 + c u v over [-1, 1]^2, of which a call, counted from 1, fails. */
typedef struct {
    double a, b, c;
    long *calls, fails_at;
} sheet;

static batten_status evaluate(const void *shape, int piece, const double uv[2], int order,
                              double *out)
{
    const sheet *s = shape;
    const double u = uv[0], v = uv[1];
    const double all[][3] = {{u, v, s->a * u * u + s->b * v * v + s->c * u * v},
                             {1, 0, 2 * s->a * u + s->c * v},
                             {0, 1, 2 * s->b * v + s->c * u},
                             {0, 0, 2 * s->a},
                             {0, 0, s->c},
                             {0, 0, 2 * s->b},
                             {0, 0, 0},
                             {0, 0, 0},
                             {0, 0, 0},
                             {0, 0, 0}};
    (void)piece;
    if (++*s->calls == s->fails_at)
        return BATTEN_INCOMPLETE;
    memcpy(out, all, (size_t)BATTEN_SURFACE_DERIVATIVES(order) * sizeof all[0]);
    return BATTEN_OK;
}

/* How many calls there were goes to s.calls. */
static batten_status contours_of(sheet s, batten_field_kind kind, batten_levels levels,
                                 bool smooth, batten_contours *out)
{
    static const int nodes[4] = {0, 1, 2, 3};
    static const double uv[8] = {-1, -1, 1, -1, 1, 1, -1, 1};
    const bat_pieces pieces = {.shape = &s,
                               .evaluate = evaluate,
                               .piece_count = 1,
                               .corner_count = 4,
                               .nodes = nodes,
                               .uv = uv,
                               .node_count = 4,
                               .size = 3};
    const batten_surface_field field = {kind, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
    *s.calls = 0;
    return bat_contours(&pieces, &field, levels.count, levels.at, 1e-2, smooth, NULL, out);
}

/* All calls in turn, where there are few; else some of them, spread over all. */
static void check_failures(sheet s, batten_field_kind kind, batten_levels levels, bool smooth)
{
    enum { MOST = 200 };
    batten_contours c = {0};
    long calls = 0;
    s.calls = &calls;
    CHECK_OK(contours_of(s, kind, levels, smooth, &c));
    CHECK(c.count > 0);
    batten_contours_release(&c);
    const long count = calls, step = count > MOST ? count / MOST : 1;
    for (long at = 1; at <= count; at += step) {
        s.fails_at = at;
        CHECK_STATUS(contours_of(s, kind, levels, smooth, &c), BATTEN_INCOMPLETE);
        CHECK_INT(calls, at); /* nothing more is asked */
        CHECK(c.lines == NULL && c.count == 0);
    }
}

TEST(an_evaluation_that_fails_anywhere_ends_contours_with_its_status)
{
    static const double saddle_levels[] = {-0.1, 0, 0.3}, bend[] = {0.5};
    check_failures((sheet){0.9, -0.7, 0.2, NULL, 0}, BATTEN_FIELD_HEIGHT,
                   (batten_levels){3, saddle_levels}, false);
    check_failures((sheet){0.9, -0.7, 0.2, NULL, 0}, BATTEN_FIELD_HEIGHT,
                   (batten_levels){3, saddle_levels}, true);
    check_failures((sheet){0.9, 0.5, 0.2, NULL, 0}, BATTEN_FIELD_GAUSSIAN,
                   (batten_levels){1, bend}, false);
}

/* In units of the sides of a triangle, which are as 1 to 2: so 4 b over a decides. */
TEST(a_point_is_isolated_where_the_hessian_is_regular_to_a_millionth)
{
    static const struct {
        double a, b, c;
        int count, kind;
    } rows[] = {
        {1, 0.3e-6, 0, 1, BATTEN_CRITICAL_LEAST},      {1, 0.2e-6, 0, 0, 0},
        {-1, -0.3e-6, 0, 1, BATTEN_CRITICAL_GREATEST}, {-1, -0.2e-6, 0, 0, 0},
        {1, -0.3e-6, 0, 1, BATTEN_CRITICAL_SADDLE},    {0.3e-6, 1, 0, 1, BATTEN_CRITICAL_LEAST},
        {0, 0, 1, 1, BATTEN_CRITICAL_SADDLE},          {1, 1, 2.1, 1, BATTEN_CRITICAL_SADDLE},
        {1, 1, 1.9, 1, BATTEN_CRITICAL_LEAST},         {1, 1, 2, 0, 0},
    };
    static const double level = 0.5;
    for (int i = 0; i < COUNT(rows); i++) {
        long calls = 0;
        const sheet s = {rows[i].a, rows[i].b, rows[i].c, &calls, 0};
        batten_contours c = {0};
        CHECK_OK(contours_of(s, BATTEN_FIELD_HEIGHT, (batten_levels){1, &level}, false, &c));
        CHECK_INT(c.critical_count, rows[i].count);
        if (c.critical_count == 1) {
            CHECK_INT(c.critical[0].kind, rows[i].kind);
            CHECK_NEAR(c.critical[0].value, 0, 1e-12);
            CHECK_NEAR(c.critical[0].u, 0, 1e-7);
            CHECK_NEAR(c.critical[0].v, 0, 1e-7);
        }
        CHECK_NEAR(c.greatest, fmax(0, rows[i].a + rows[i].b + fabs(rows[i].c)), 1e-3);
        batten_contours_release(&c);
    }
}
