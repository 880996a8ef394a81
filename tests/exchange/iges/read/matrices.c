/* Matrices, and the points and directions that entities refer to. */
#include "exchange/iges/text.h"

TEST(a_chain_of_matrices_applies_the_inner_one_first)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 3, 0, "00000000", "110,1.,0.,0.,0.,0.,0.;");
    /* A quarter turn about z, then, by its own matrix, a move along x. */
    iges_add(&file, 124, 0, 5, 0, "00000000", "124,0.,-1.,0.,0.,1.,0.,0.,0.,0.,0.,1.,0.;");
    iges_add(&file, 124, 0, 0, 0, "00000000", "124,1.,0.,0.,10.,0.,1.,0.,0.,0.,0.,1.,0.;");
    iges_add(&file, 128, 0, 5, 0, "00000000", IGES_SURFACE);
    batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
    const double *points = batten_curve_points(batten_model_object(model, 0)->curve);
    CHECK_BITS(points[0], 10.0);
    CHECK_BITS(points[1], 1.0);
    CHECK_BITS(points[3], 10.0);
    CHECK_BITS(batten_surface_points(batten_model_object(model, 1)->surface)[0], 10.0);
    batten_model_unref(model);
}

static void check_bad_matrix(int transform, int inner, const char *matrix, const char *words)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, transform, 0, "00000000", IGES_LINE);
    iges_add(&file, 124, 0, inner, 0, "00000000", matrix);
    iges_check_left_out(&file, words);
}

TEST(Q4_references_to_nothing_to_another_type_or_in_a_ring_leave_the_entity_out)
{
    static const char unit[] = "124,1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,0.;";
    check_bad_matrix(99, 0, unit, "it refers to entity D99, which is missing");
    check_bad_matrix(1, 0, unit, "it refers to entity D1 as type 124, which is of type 110");
    check_bad_matrix(2, 0, unit, "2 is not the odd number of an entity");
    check_bad_matrix(-3, 0, unit, "-3 is not the odd number");
    check_bad_matrix(3, 3, unit, "its matrices refer to one another in a ring");
    check_bad_matrix(3, 0, "124,1.,0.,0.;", "the matrix D3 differs from a rotation by 1");
    check_bad_matrix(3, 0, "124,2.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,0.;",
                     "differs from a rotation by 3");
    check_bad_matrix(3, 0, "124,a;", "parameter 1, 'a', is not a number");
    check_bad_matrix(3, 0, "124,1.", "is not a number");
}

TEST(a_matrix_that_is_nearly_a_rotation_is_made_one_with_a_note)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 3, 0, "00000000", "110,1.,0.,0.,0.,0.,0.;");
    iges_add(&file, 124, 0, 0, 0, "00000000",
             "124,1.0000001,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,0.;");
    batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO,
                                      "the matrix differs from a rotation by 2e-07; made a "
                                      "rotation");
    CHECK_BITS(batten_curve_points(batten_model_object(model, 0)->curve)[0], 1.0);
    batten_model_unref(model);
}

/* A rotation by three angles with errors of single precision in all its numbers: what is made of it
 * keeps lengths and angles, and the direction of its first row. */
TEST(a_matrix_of_seven_digits_becomes_a_rotation_in_all_its_rows)
{
    static const double m[3][3] = {{0.7351801, -0.6269601, 0.2577201},
                                   {0.4620301, 0.7338501, 0.4979801},
                                   {-0.5013501, -0.2470301, 0.8292401}};
    double q[3][3], w[3][3];
    /* Their own rows, made orthonormal first, and then spoiled in the seventh digit. */
    memcpy(q, m, sizeof q);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < i; j++) {
            double dot = 0;
            for (int k = 0; k < 3; k++)
                dot += q[i][k] * q[j][k];
            for (int k = 0; k < 3; k++)
                q[i][k] -= dot * q[j][k];
        }
        const double length = sqrt(q[i][0] * q[i][0] + q[i][1] * q[i][1] + q[i][2] * q[i][2]);
        for (int k = 0; k < 3; k++)
            q[i][k] /= length;
    }
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            w[i][k] = q[i][k] + 1e-7 * (1 + i - 2 * k % 3);
    iges_text file = iges_begin();
    char text[300] = "124";
    iges_add(&file, 106, 2, 3, 0, "00000000", "106,2,3,1.,0.,0.,0.,1.,0.,0.,0.,1.;");
    for (int i = 0; i < 3; i++)
        snprintf(text + strlen(text), 100, ",%.17g,%.17g,%.17g,0.", w[i][0], w[i][1], w[i][2]);
    iges_add(&file, 124, 0, 0, 0, "00000000", strcat(text, ";"));
    batten_model *model =
        read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "made a rotation");
    const double *p = batten_model_object(model, 0)->points; /* the columns */
    const double first = sqrt(w[0][0] * w[0][0] + w[0][1] * w[0][1] + w[0][2] * w[0][2]);
    for (int i = 0; i < 3; i++) {
        CHECK_NEAR(p[3 * i], w[0][i] / first, 1e-15);
        for (int j = 0; j < 3; j++) {
            double dot = 0;
            for (int k = 0; k < 3; k++)
                dot += p[3 * i + k] * p[3 * j + k];
            CHECK_NEAR(dot, i == j, 1e-15);
            CHECK_NEAR(p[3 * i + j], q[j][i], 1e-6);
        }
    }
    batten_model_unref(model);
}

/* Points are moved by all of a matrix, directions are turned only. */
TEST(the_matrices_of_points_and_directions_place_a_surface)
{
    static const struct {
        int point, direction; /* their matrices */
        double low[3], high[3];
    } cases[] = {{0, 0, {0, 0, 0}, {2, 2, 0}},
                 {11, 0, {1, 1, 5}, {3, 3, 5}},
                 {0, 11, {0, 0, 0}, {2, 0, 2}}};
    /* The plane of a square loop whose own corners lie in it: what differs is refused. */
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        char text[200] = "106,2,5";
        const double *a = cases[i].low, *b = cases[i].high;
        for (int k = 0; k < 5; k++) {
            const double s = k == 1 || k == 2, t = k == 2 || k == 3;
            snprintf(text + strlen(text), 60, ",%g,%g,%g", a[0] + s * (b[0] - a[0]),
                     a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]));
        }
        iges_add(&file, 116, 0, cases[i].point, 0, "00010000", "116,0.,0.,0.;");     /* 1 */
        iges_add(&file, 123, 0, cases[i].direction, 0, "00010200", "123,0.,0.,1.;"); /* 3 */
        iges_add(&file, 190, 0, 0, 0, "00010000", "190,1,3;");                       /* 5 */
        iges_add(&file, 106, 12, 0, 0, "00010000", strcat(text, ";"));               /* 7 */
        iges_add(&file, 141, 0, 0, 0, "00010000", "141,0,0,5,1,7,1,0;");             /* 9 */
        iges_add(&file, 124, 0, 0, 0, "00000000",
                 i == 1 ? "124,1.,,,,,1.,,,,,1.,5.;" /* 11 */
                        : "124,1.,0.,0.,0.,0.,0.,-1.,9.,0.,1.,0.,9.;");
        iges_add(&file, 143, 0, 0, 0, "00000000", "143,0,5,1,9;");
        batten_model *model = NULL;
        batten_notes *notes = NULL;
        CHECK_OK(batten_notes_create(9, &notes));
        CHECK_OK(read_text(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, notes, &model));
        CHECK(!has_note(notes, "miss their surfaces"));
        batten_notes_free(notes);
        batten_model_unref(model);
    }
}
