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
