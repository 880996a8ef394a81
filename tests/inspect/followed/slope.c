/* Directions on graphs z = a x^2 + b x y + c y^2, whose fundamental forms are known everywhere. */
#include "inspect/followed/slope.h"
#include "support/test.h"

#include <batten/standard.h>

typedef struct {
    double a, b, c;
} bowl;

/* Over [-1, 1]^2, with u = x and v = y. */
static batten_surface *graph(const bowl *g)
{
    static const double knots[6] = {-1, -1, -1, 1, 1, 1}, x[3] = {-1, 0, 1},
                        square[3] = {1, -1, 1};
    const batten_axis axis = {2, 3, knots, false};
    double points[3][3][3];
    batten_surface *out = NULL;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            points[i][j][0] = x[i];
            points[i][j][1] = x[j];
            points[i][j][2] = g->a * square[i] + g->b * x[i] * x[j] + g->c * square[j];
        }
    CHECK_OK(batten_surface_create(3, &axis, &axis, points[0][0], NULL, &out));
    return out;
}

static bat_slope_field field_on(const batten_surface *surface, batten_line_kind kind)
{
    bat_slope_field field = {.surface = surface, .kind = kind};
    for (int k = 0; k < 2; k++)
        field.domain[k] = batten_surface_domain(surface, k ? BATTEN_V : BATTEN_U);
    return field;
}

static double product(batten_vec3 a, batten_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* E, F, G; L, M, N; and the normal. */
typedef struct {
    double first[3], second[3], k1, k2;
    batten_vec3 su, sv, normal;
} forms;

static forms forms_of(const bowl *g, double x, double y)
{
    const double p = 2 * g->a * x + g->b * y, q = g->b * x + 2 * g->c * y,
                 w = sqrt(1 + p * p + q * q);
    forms f = {{1 + p * p, p * q, 1 + q * q},
               {2 * g->a / w, g->b / w, 2 * g->c / w},
               0,
               0,
               {1, 0, p},
               {0, 1, q},
               {-p / w, -q / w, 1 / w}};
    const double *e = f.first, *l = f.second, area = e[0] * e[2] - e[1] * e[1];
    const double mean = (e[0] * l[2] - 2 * e[1] * l[1] + e[2] * l[0]) / (2 * area),
                 root = sqrt(mean * mean - (l[0] * l[2] - l[1] * l[1]) / area);
    f.k1 = mean + root;
    f.k2 = mean - root;
    return f;
}

static double form(const double m[3], const double a[2], const double b[2])
{
    return m[0] * a[0] * b[0] + m[1] * (a[0] * b[1] + a[1] * b[0]) + m[2] * a[1] * b[1];
}

static void check_vector(batten_vec3 a, batten_vec3 b, double tolerance)
{
    CHECK_NEAR(a.x, b.x, tolerance);
    CHECK_NEAR(a.y, b.y, tolerance);
    CHECK_NEAR(a.z, b.z, tolerance);
}

/* The rates belong to the tangent, which is a unit vector on the side asked for. */
static void check_tangent(const bat_slope *s, const forms *f, batten_vec3 onward)
{
    CHECK_INT(s->obstacle, BATTEN_LINE_AT_LENGTH);
    const double a = s->rates[0], b = s->rates[1];
    check_vector(s->tangent,
                 (batten_vec3){a * f->su.x + b * f->sv.x, a * f->su.y + b * f->sv.y,
                               a * f->su.z + b * f->sv.z},
                 1e-13);
    CHECK_NEAR(product(s->tangent, s->tangent), 1, 1e-13);
    CHECK(product(s->tangent, onward) >= 0);
}

static const bowl bowls[] = {
    {0.5, 0.3, -0.4}, {-0.2, 1.1, 0.7}, {0.1, -0.9, -0.2}, {1, 0.2, 0.6}};
static const double places[][2] = {{0, 0}, {0.3, -0.7}, {-0.9, 0.2}, {0.5, 0.6}};

TEST(principal_directions_are_those_of_the_two_fundamental_forms)
{
    for (int i = 0; i < COUNT(bowls); i++) {
        batten_surface *surface = graph(&bowls[i]);
        for (int n = 0; n < 4 * COUNT(places); n++) {
            const double *at = places[n / 4], place[BAT_SLOPE_SIZE] = {at[0], at[1]};
            const forms f = forms_of(&bowls[i], at[0], at[1]);
            const batten_vec3 onward =
                n & 2 ? (batten_vec3){0.6, -0.5, 0.1} : (batten_vec3){-0.6, 0.5, 0.1};
            const bat_slope_field field =
                field_on(surface, n & 1 ? BATTEN_LINE_CURVATURE2 : BATTEN_LINE_CURVATURE1);
            bat_slope s;
            CHECK_OK(bat_slope_at(&field, place, onward, &s));
            check_tangent(&s, &f, onward);
            const double one[2] = {1, 0}, two[2] = {0, 1}, k = n & 1 ? f.k2 : f.k1;
            CHECK_NEAR(form(f.second, s.rates, one), k * form(f.first, s.rates, one), 1e-12);
            CHECK_NEAR(form(f.second, s.rates, two), k * form(f.first, s.rates, two), 1e-12);
            CHECK_NEAR(s.spread, (f.k1 - f.k2) / fmax(fabs(f.k1), fabs(f.k2)), 1e-12);
            check_vector(s.point,
                         (batten_vec3){at[0], at[1],
                                       bowls[i].a * at[0] * at[0] + bowls[i].b * at[0] * at[1] +
                                           bowls[i].c * at[1] * at[1]},
                         1e-15);
        }
        batten_surface_unref(surface);
    }
}

TEST(asymptotic_directions_have_no_curvature_and_lie_on_either_side_of_the_first_principal_one)
{
    for (int i = 0; i < 3; i++) {
        batten_surface *surface = graph(&bowls[i]);
        for (int n = 0; n < 4 * COUNT(places); n++) {
            const double *at = places[n / 4], place[BAT_SLOPE_SIZE] = {at[0], at[1]};
            const forms f = forms_of(&bowls[i], at[0], at[1]);
            const batten_vec3 onward =
                n & 2 ? (batten_vec3){0.6, -0.5, 0.1} : (batten_vec3){-0.6, 0.5, 0.1};
            const bat_slope_field field = field_on(surface, n & 1 ? BATTEN_LINE_ASYMPTOTIC2
                                                                  : BATTEN_LINE_ASYMPTOTIC1),
                                  principal = field_on(surface, BATTEN_LINE_CURVATURE1);
            bat_slope s, p;
            CHECK_OK(bat_slope_at(&field, place, onward, &s));
            CHECK_OK(bat_slope_at(&principal, place, onward, &p));
            check_tangent(&s, &f, onward);
            CHECK_NEAR(form(f.second, s.rates, s.rates), 0, 1e-13);
            const batten_vec3 a = p.tangent, b = s.tangent,
                              c = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
                                   a.x * b.y - a.y * b.x};
            CHECK((product(c, f.normal) * product(a, b) > 0) == !(n & 1));
        }
        batten_surface_unref(surface);
    }
}

TEST(a_geodesic_turns_towards_the_normal_by_its_normal_curvature)
{
    for (int i = 0; i < COUNT(bowls); i++) {
        batten_surface *surface = graph(&bowls[i]);
        const bat_slope_field field = field_on(surface, BATTEN_LINE_GEODESIC);
        for (int n = 0; n < 3 * COUNT(places); n++) {
            const double *at = places[n / 3];
            double place[BAT_SLOPE_SIZE] = {at[0], at[1]};
            const forms f = forms_of(&bowls[i], at[0], at[1]);
            const batten_vec3 direction = {5 * cos(n), 5 * sin(n), 0.1 * n};
            bat_slope s;
            CHECK(bat_slope_begin(&field, place, direction));
            CHECK_OK(bat_slope_at(&field, place, direction, &s));
            check_tangent(&s, &f, direction);
            check_vector(s.tangent, (batten_vec3){place[2], place[3], place[4]}, 1e-15);
            /* What is left of the direction beside the tangent is along the normal. */
            const double along = product(direction, s.tangent),
                         up = product(direction, f.normal);
            check_vector(direction,
                         (batten_vec3){along * s.tangent.x + up * f.normal.x,
                                       along * s.tangent.y + up * f.normal.y,
                                       along * s.tangent.z + up * f.normal.z},
                         1e-13);
            const double k = form(f.second, s.rates, s.rates);
            check_vector((batten_vec3){s.rates[2], s.rates[3], s.rates[4]},
                         (batten_vec3){k * f.normal.x, k * f.normal.y, k * f.normal.z}, 1e-13);
            CHECK_NEAR(s.spread, 1, 0);
        }
        batten_surface_unref(surface);
    }
}

static batten_line_end obstacle_at_origin(const bowl *g, batten_line_kind kind)
{
    const double place[BAT_SLOPE_SIZE] = {0};
    batten_surface *surface = graph(g);
    const bat_slope_field field = field_on(surface, kind);
    bat_slope s;
    CHECK_OK(bat_slope_at(&field, place, (batten_vec3){1, 0, 0}, &s));
    batten_surface_unref(surface);
    return s.obstacle;
}

TEST(curvatures_that_differ_by_a_millionth_or_less_have_no_directions)
{
    for (int k = 0; k < 2; k++)
        for (int back = 0; back < 2; back++) {
            const double e = k ? 1.01e-6 : 0.99e-6, s = back ? -1 : 1;
            const batten_line_end none = BATTEN_LINE_AT_LENGTH;
            for (int kind = 0; kind < 2; kind++) {
                const bowl round = {s, 0, s * (1 + e)}, flat = {s, 0, -s * e};
                CHECK_INT(obstacle_at_origin(&round, kind ? BATTEN_LINE_CURVATURE2
                                                          : BATTEN_LINE_CURVATURE1),
                          k ? none : BATTEN_LINE_AT_UMBILIC);
                CHECK_INT(obstacle_at_origin(&flat, kind ? BATTEN_LINE_ASYMPTOTIC2
                                                         : BATTEN_LINE_ASYMPTOTIC1),
                          k ? none : BATTEN_LINE_AT_PARABOLIC);
            }
        }
    const bowl level = {0, 0, 0};
    CHECK_INT(obstacle_at_origin(&level, BATTEN_LINE_CURVATURE1), BATTEN_LINE_AT_UMBILIC);
    CHECK_INT(obstacle_at_origin(&level, BATTEN_LINE_ASYMPTOTIC1), BATTEN_LINE_AT_PARABOLIC);
    CHECK_INT(obstacle_at_origin(&level, BATTEN_LINE_GEODESIC), BATTEN_LINE_AT_LENGTH);
}

TEST(where_there_is_no_tangent_plane_no_line_has_a_slope)
{
    const batten_frame world = batten_frame_world();
    batten_surface *ball = NULL;
    CHECK_OK(batten_surface_sphere(&world, 2, &ball));
    for (int kind = BATTEN_LINE_CURVATURE1; kind <= BATTEN_LINE_GEODESIC; kind++) {
        const bat_slope_field field = field_on(ball, (batten_line_kind)kind);
        double place[BAT_SLOPE_SIZE] = {field.domain[0].a, field.domain[1].b, 1};
        bat_slope s;
        CHECK_OK(bat_slope_at(&field, place, (batten_vec3){1, 0, 0}, &s));
        CHECK_INT(s.obstacle, BATTEN_LINE_AT_SINGULAR);
        CHECK(!bat_slope_begin(&field, place, (batten_vec3){1, 0, 0}));
        CHECK_NEAR(place[2], 1, 0);
    }
    batten_surface_unref(ball);
}

TEST(a_direction_square_to_the_surface_starts_no_geodesic)
{
    const bowl level = {0, 0, 0};
    batten_surface *surface = graph(&level);
    const bat_slope_field field = field_on(surface, BATTEN_LINE_GEODESIC);
    double place[BAT_SLOPE_SIZE] = {0.5, 0.5};
    CHECK(!bat_slope_begin(&field, place, (batten_vec3){0, 0, 1}));
    CHECK(!bat_slope_begin(&field, place, (batten_vec3){0, 0, 0}));
    CHECK(!bat_slope_begin(&field, place, (batten_vec3){0.9e-12, 0, 1}));
    CHECK(bat_slope_begin(&field, place, (batten_vec3){0, -1.1e-12, 1}));
    CHECK(place[2] == 0 && place[3] == -1 && place[4] == 0);
    batten_surface_unref(surface);
}

TEST(places_come_around_where_a_surface_is_closed_and_stay_on_the_rim_where_not)
{
    const bat_slope_field field = {.domain = {{1, 3}, {-2, 6}}, .closed = {true, false}};
    static const struct {
        double place[2], uv[2], beyond;
    } rows[] = {{{1.5, 2}, {1.5, 2}, -0.5},     {{3.5, 7}, {1.5, 6}, 0.125},
                {{0.5, -4}, {2.5, -2}, 0.25},   {{7.25, 6}, {1.25, 6}, 0},
                {{-4.75, 4}, {1.25, 4}, -0.25}, {{3, -2}, {1, -2}, 0}};
    for (int i = 0; i < COUNT(rows); i++) {
        double uv[2];
        bat_slope_wrap(&field, rows[i].place, uv);
        CHECK_NEAR(uv[0], rows[i].uv[0], 1e-15);
        CHECK_NEAR(uv[1], rows[i].uv[1], 0);
        CHECK_NEAR(bat_slope_beyond(&field, rows[i].place), rows[i].beyond, 1e-15);
    }
    const bat_slope_field open = {.domain = {{1, 3}, {-2, 6}}},
                          ring = {.domain = {{1, 3}, {-2, 6}}, .closed = {true, true}};
    CHECK_NEAR(bat_slope_beyond(&open, (const double[2]){3.5, 2}), 0.25, 1e-15);
    CHECK_NEAR(bat_slope_beyond(&open, (const double[2]){0.5, 2}), 0.25, 1e-15);
    CHECK(bat_slope_beyond(&ring, (const double[2]){9, 9}) < 0);
}
