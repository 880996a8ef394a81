#include "inspect/contours/field.h"

#include "support/test.h"

/* Each kind with what it needs, and how it changes where all lengths are s times as large. */
static const struct {
    batten_surface_field field;
    int power;
} kinds[] = {
    {{BATTEN_FIELD_HEIGHT, {1, 2, 2}, {0, 0, 0}, {0, 0, 0}}, 1},
    {{BATTEN_FIELD_GAUSSIAN, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, -2},
    {{BATTEN_FIELD_MEAN, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, -1},
    {{BATTEN_FIELD_KAPPA1, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, -1},
    {{BATTEN_FIELD_KAPPA2, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, -1},
    {{BATTEN_FIELD_ISOPHOTE, {1, 0, 3}, {0, 0, 0}, {0, 0, 0}}, 0},
    {{BATTEN_FIELD_DRAFT, {1, 0, 3}, {0, 0, 0}, {0, 0, 0}}, 0},
    {{BATTEN_FIELD_HIGHLIGHT, {0, 1, 0}, {1, 0, 9}, {0, 0, 0}}, 1},
    {{BATTEN_FIELD_REFLECTION, {0, 1, 0}, {1, 0, 9}, {1, 0, 2}}, 1},
    {{BATTEN_FIELD_SILHOUETTE, {0, 0, 0}, {9, -4, 5}, {0, 0, 0}}, 0},
    {{BATTEN_FIELD_ABSOLUTE, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, -1},
    {{BATTEN_FIELD_ZEBRA, {0, 1, 1}, {0, 0, 0}, {1, 0, 2}}, 0},
};

/* A bumpy sheet of degrees 3 and 4, about the square from (0, 0) to (3, 4), `size` times. */
static batten_surface *make_sheet(double size)
{
    test_random random = test_random_begin("sheet");
    const double u[8] = {0, 0, 0, 0, 1, 1, 1, 1}, v[10] = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1};
    double points[4][5][3];
    batten_surface *sheet = NULL;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 5; j++) {
            points[i][j][0] = size * (i + test_random_in(&random, -0.3, 0.3));
            points[i][j][1] = size * (j + test_random_in(&random, -0.3, 0.3));
            points[i][j][2] = size * test_random_in(&random, -0.8, 0.8);
        }
    CHECK_OK(batten_surface_create(3, &(batten_axis){3, 4, u, false},
                                   &(batten_axis){4, 5, v, false}, &points[0][0][0], NULL,
                                   &sheet));
    return sheet;
}

static double value_at(const batten_surface *sheet, const batten_surface_field *field, double u,
                       double v, double gradient[2])
{
    double derivatives[BATTEN_SURFACE_DERIVATIVES(3) * 3];
    CHECK_OK(batten_surface_evaluate(sheet, u, v, bat_field_order(field), derivatives));
    return bat_field_value(field, derivatives, gradient);
}

TEST(the_gradient_of_a_field_is_that_of_its_differences)
{
    batten_surface *sheet = make_sheet(1);
    const double h = 1e-4;
    for (int k = 0; k < COUNT(kinds); k++)
        for (int i = 1; i < 6; i++)
            for (int j = 1; j < 6; j++) {
                batten_surface_field field;
                const double u = i / 6.0, v = j / 6.0;
                double gradient[2], other[2], rise[2];
                CHECK_OK(bat_field_prepare(&kinds[k].field, &field));
                CHECK(isfinite(value_at(sheet, &field, u, v, gradient)));
                rise[0] = value_at(sheet, &field, u + h, v, other) -
                          value_at(sheet, &field, u - h, v, other);
                rise[1] = value_at(sheet, &field, u, v + h, other) -
                          value_at(sheet, &field, u, v - h, other);
                for (int c = 0; c < 2; c++)
                    CHECK_NEAR(gradient[c], rise[c] / (2 * h), 1e-4 * (1 + fabs(gradient[c])));
            }
    batten_surface_unref(sheet);
}

TEST(fields_scale_with_the_lengths_of_the_surface)
{
    const double s = 0x1p200;
    batten_surface *sheet = make_sheet(1), *huge = make_sheet(s);
    for (int k = 0; k < COUNT(kinds); k++) {
        batten_surface_field field, far;
        double gradient[2], large[2];
        CHECK_OK(bat_field_prepare(&kinds[k].field, &field));
        far = field;
        far.point = (batten_vec3){s * field.point.x, s * field.point.y, s * field.point.z};
        const double value = value_at(sheet, &field, 0.3, 0.6, gradient),
                     there = value_at(huge, &far, 0.3, 0.6, large), by = pow(s, kinds[k].power);
        CHECK_NEAR(there / by, value, 1e-12 * (1 + fabs(value)));
        for (int c = 0; c < 2; c++)
            CHECK_NEAR(large[c] / by, gradient[c], 1e-11 * (1 + fabs(gradient[c])));
        CHECK_NEAR(bat_field_roundoff(&field, 8) / bat_field_roundoff(&field, 1),
                   pow(8, kinds[k].power), 1e-12);
        CHECK(bat_field_roundoff(&field, 1) > 0 && bat_field_roundoff(&field, 1) <= 1e-12);
    }
    batten_surface_unref(sheet);
    batten_surface_unref(huge);
}

TEST(fields_of_normals_have_no_value_where_there_is_no_tangent_plane)
{
    static const struct {
        double su[3], sv[3];
        bool is_plane;
    } rows[] = {
        {{1, 0, 0}, {0, 1, 0}, true},
        {{1, 0, 0}, {1e-9, 1e-9, 0}, true},
        {{0, 0, 0}, {0, 1, 0}, false},
        {{1, 0, 0}, {0, 0, 0}, false},
        {{1, 2, 3}, {-2, -4, -6}, false},
        {{1, 0, 0}, {0, 1e-14, 0}, false},
        {{1e-14, 0, 0}, {0, 1, 0}, false},
        {{HUGE_VAL, 0, 0}, {0, 1, 0}, false},
        {{1, 0, 0}, {0, HUGE_VAL, 0}, false},
        /* on either side of 64 roundings of a right angle, and of 4096 of sqrt 3, the distance */
        {{1, 0, 0}, {1, 60 * DBL_EPSILON, 0}, false},
        {{1, 0, 0}, {1, 68 * DBL_EPSILON, 0}, true},
        {{3, 0, 0}, {5, 300 * DBL_EPSILON, 0}, false},
        {{1, 0, 0}, {0, 7090 * DBL_EPSILON, 0}, false},
        {{1, 0, 0}, {0, 7100 * DBL_EPSILON, 0}, true},
        {{7090 * DBL_EPSILON, 0, 0}, {0, 1, 0}, false},
        {{7100 * DBL_EPSILON, 0, 0}, {0, 1, 0}, true},
        {{4, 0, 0}, {0, 16380 * DBL_EPSILON, 0}, false},
        {{4, 0, 0}, {0, 16390 * DBL_EPSILON, 0}, true}};
    const batten_surface_field field = {BATTEN_FIELD_ISOPHOTE, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
    for (int i = 0; i < COUNT(rows); i++) {
        double derivatives[BATTEN_SURFACE_DERIVATIVES(2) * 3] = {1, 1, 1}, gradient[2];
        memcpy(derivatives + 3, rows[i].su, sizeof rows[i].su);
        memcpy(derivatives + 6, rows[i].sv, sizeof rows[i].sv);
        const double value = bat_field_value(&field, derivatives, gradient);
        if (rows[i].is_plane)
            CHECK_NEAR(value, 1, 1e-12);
        else
            CHECK(isnan(value) && isnan(gradient[0]) && isnan(gradient[1]));
    }
}

TEST(lights_and_eyes_have_no_value_along_their_lines)
{
    const double flat[BATTEN_SURFACE_DERIVATIVES(2) * 3] = {4, 0, 1, 1, 0, 0, 0, 1, 0};
    const batten_surface_field
        along_light = {BATTEN_FIELD_HIGHLIGHT, {0, 0, 1}, {0, 0, 9}, {0, 0, 0}},
        in_eye = {BATTEN_FIELD_SILHOUETTE, {0, 0, 0}, {4, 0, 1}, {0, 0, 0}},
        above = {BATTEN_FIELD_SILHOUETTE, {0, 0, 0}, {4, 0, 3}, {0, 0, 0}};
    double gradient[2];
    CHECK(isnan(bat_field_value(&along_light, flat, gradient)));
    CHECK(isnan(bat_field_value(&in_eye, flat, gradient)));
    CHECK_NEAR(bat_field_value(&above, flat, gradient), 1, 1e-15);
}

TEST(fields_without_directions_are_refused)
{
    static const struct {
        batten_surface_field field;
        batten_status status;
        const char *says;
    } rows[] = {
        {{BATTEN_FIELD_HEIGHT, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
         BATTEN_BAD_ARGUMENT,
         "the direction of the field is 0"},
        {{BATTEN_FIELD_DRAFT, {0, HUGE_VAL, 0}, {0, 0, 0}, {0, 0, 0}},
         BATTEN_NOT_FINITE,
         "the direction ("},
        {{BATTEN_FIELD_REFLECTION, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}},
         BATTEN_BAD_ARGUMENT,
         "the direction to the eye of the field is 0"},
        {{BATTEN_FIELD_SILHOUETTE, {0, 0, 0}, {0, NAN, 0}, {0, 0, 0}},
         BATTEN_NOT_FINITE,
         "the point (0, "},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_surface_field out = {.kind = BATTEN_FIELD_MEAN};
        CHECK_STATUS(bat_field_prepare(&rows[i].field, &out), rows[i].status);
        CHECK_MESSAGE(rows[i].says);
        CHECK_INT(out.kind, BATTEN_FIELD_MEAN);
    }
    batten_surface_field tiny = {BATTEN_FIELD_HEIGHT, {0, 0, 3e-320}, {0, 0, 0}, {0, 0, 0}};
    CHECK_OK(bat_field_prepare(&tiny, &tiny));
    CHECK_NEAR(tiny.direction.z, 1, 1e-15);
}

/* On the torus the curvatures are 1 / r around the tube and c / (R + r c) about the axis, c the cosine of the angle
 * around the tube; a mirror of normal n shows the eye e the ray 2 (e . n) n - e. */
TEST(absolute_curvature_and_zebra_of_a_torus_are_those_of_its_equation)
{
    const batten_frame world = batten_frame_world();
    const double R = 3, r = 1.5;
    const batten_surface_field absolute = {BATTEN_FIELD_ABSOLUTE,
                                           {0, 0, 0},
                                           {0, 0, 0},
                                           {0, 0, 0}},
                               zebra = {BATTEN_FIELD_ZEBRA, {0, 3, 4}, {0, 0, 0}, {0, 2, 0}};
    batten_surface *torus = NULL;
    CHECK_OK(batten_surface_torus(&world, R, r, &torus));
    const batten_interval u = batten_surface_domain(torus, BATTEN_U),
                          v = batten_surface_domain(torus, BATTEN_V);
    for (int i = 0; i < 40; i++) {
        const double uv[2] = {u.a + (u.b - u.a) * (i + 0.3) / 40,
                              v.a + (v.b - v.a) * (7 * i % 40 + 0.6) / 40};
        double p[3], value;
        CHECK_OK(batten_surface_evaluate(torus, uv[0], uv[1], 0, p));
        const double ring = hypot(p[0], p[1]), c = (ring - R) / r;
        CHECK_OK(batten_surface_field_values(torus, &absolute, 1, uv, &value));
        CHECK_NEAR(value, 1 / r + fabs(c / ring), 1e-11);
        const double n[3] = {c * p[0] / ring, c * p[1] / ring, p[2] / r}, facing = 2 * n[1];
        CHECK_OK(batten_surface_field_values(torus, &zebra, 1, uv, &value));
        CHECK_NEAR(value, 0.6 * (facing * n[1] - 1) + 0.8 * facing * n[2], 1e-12);
    }
    batten_surface_unref(torus);
}

TEST(a_zebra_needs_an_eye_and_tubes_and_absolute_curvature_nothing)
{
    batten_surface_field out;
    const batten_surface_field blind = {BATTEN_FIELD_ZEBRA, {0, 1, 0}, {0, 0, 0}, {0, 0, 0}},
                               bare = {BATTEN_FIELD_ZEBRA, {0, 0, 0}, {0, 0, 0}, {0, 1, 0}},
                               absolute = {
                                   BATTEN_FIELD_ABSOLUTE, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    CHECK_STATUS(bat_field_prepare(&blind, &out), BATTEN_BAD_ARGUMENT);
    CHECK_CONTAINS(batten_message(), "eye");
    CHECK_STATUS(bat_field_prepare(&bare, &out), BATTEN_BAD_ARGUMENT);
    CHECK_OK(bat_field_prepare(&absolute, &out));
}

/* Derivatives of z = (x^2 + y^2) / 2 + ... at 0, where H_x = (z_xxx + z_xyy) / 2 and H_y = (z_xxy + z_yyy) / 2. */
TEST(at_an_umbilic_principal_curvatures_run_as_their_mean)
{
    static const batten_field_kind principal[] = {BATTEN_FIELD_KAPPA1, BATTEN_FIELD_KAPPA2,
                                                  BATTEN_FIELD_MEAN};
    static const double derivatives[30] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0,
                                           0, 0, 1, 0, 0, 6, 0, 0, 2, 0, 0, 4, 0, 0, -3};
    for (int i = 0; i < COUNT(principal); i++) {
        const batten_surface_field field = {principal[i], {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
        double gradient[2] = {7, 7};
        CHECK_BITS(bat_field_value(&field, derivatives, gradient), 1);
        CHECK_NEAR(gradient[0], 5, 1e-15);
        CHECK_NEAR(gradient[1], -0.5, 1e-15);
    }
}

/* By lengths of the shape: heights and distances grow with it, curvatures fall; angles stay. */
TEST(the_rounding_of_a_field_has_the_unit_of_the_field)
{
    static const struct {
        batten_field_kind kind;
        double roundoff;
        int order;
    } rows[] = {{BATTEN_FIELD_HEIGHT, 4e-14, 1},     {BATTEN_FIELD_GAUSSIAN, 6.25e-14, 3},
                {BATTEN_FIELD_MEAN, 2.5e-13, 3},     {BATTEN_FIELD_KAPPA1, 2.5e-13, 3},
                {BATTEN_FIELD_KAPPA2, 2.5e-13, 3},   {BATTEN_FIELD_ABSOLUTE, 2.5e-13, 3},
                {BATTEN_FIELD_ISOPHOTE, 1e-12, 2},   {BATTEN_FIELD_DRAFT, 1e-12, 2},
                {BATTEN_FIELD_HIGHLIGHT, 4e-12, 2},  {BATTEN_FIELD_REFLECTION, 4e-12, 2},
                {BATTEN_FIELD_SILHOUETTE, 1e-12, 2}, {BATTEN_FIELD_ZEBRA, 1e-12, 2}};
    for (int i = 0; i < COUNT(rows); i++) {
        const batten_surface_field field = {rows[i].kind, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
        CHECK_NEAR(bat_field_roundoff(&field, 4), rows[i].roundoff, 1e-26);
        CHECK_INT(bat_field_order(&field), rows[i].order);
    }
}
