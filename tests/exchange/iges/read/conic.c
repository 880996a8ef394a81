/* 104: conics that are none, and by how much their ends are off them. */
#include "exchange/iges/faces.h"

/* a x^2 + b xy + c y^2 + d x + e y + f = 0. */
static const struct {
    const char *parameters, *said;
} nothing[] = {
    {"104,1.,0.,1.,0.,0.,1.,0.,1.,0.,0.,1.;", "the equation 1 0 1 0 0 1 describes no curve"},
    {"104,1.,0.,1.,0.,0.,0.,0.,1.,0.,0.,1.;", "the equation 1 0 1 0 0 0 describes no curve"},
    {"104,1.,0.,-1.,0.,0.,0.,0.,1.,1.,2.,2.;", "the equation 1 0 -1 0 0 0 describes no curve"},
    {"104,0.,0.,1.,0.,0.,-1.,0.,1.,1.,2.,1.;", "the equation 0 0 1 0 0 -1 describes no curve"},
    {"104,1.,2.,1.,0.,0.,0.,0.,1.,-1.,2.,-2.;", "the equation 1 2 1 0 0 0 describes no curve"},
    {"104,-1.,0.,-4.,0.,0.,-4.,0.,1.,0.,0.,1.;",
     "the equation -1 0 -4 0 0 -4 describes no curve"},
    {"104,0.,0.,0.,1.,1.,1.,0.,0.,0.,1.,1.;", "an equation without a quadratic term"},
};

TEST(points_and_pairs_of_lines_and_nothing_at_all_are_no_conics)
{
    for (int i = 0; i < COUNT(nothing); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 104, 0, 0, 0, "00000000", nothing[i].parameters);
        iges_check_left_out(&file, nothing[i].said);
    }
}

/* Each form that is declared, for each kind that the equation has. */
TEST(a_form_that_its_equation_has_not_is_noted_by_name)
{
    static const char *const names[] = {"", "an ellipse", "a hyperbola", "a parabola"};
    static const char *const texts[] = {"104,1.,0.,4.,0.,0.,-4.,3.,2.,0.,0.,1.;",
                                        "104,1.,0.,-1.,0.,0.,-1.,3.,1.25,.75,1.25,-.75;",
                                        "104,1.,0.,0.,0.,-1.,0.,3.,-2.,4.,1.,1.;"};
    for (int form = 0; form < 4; form++)
        for (int kind = 0; kind < 3; kind++) {
            char words[100] = "";
            iges_text file = iges_begin();
            iges_add(&file, 104, form, 0, 0, "00000000", texts[kind]);
            if (form > 0 && form != kind + 1)
                snprintf(words, sizeof words,
                         "it is declared %s, but its equation is not; the equation is used",
                         names[form]);
            batten_model_unref(
                read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, words));
        }
}

/* The circle of radius 1 about (2, 3): the end that is farther off it counts. */
TEST(ends_off_the_conic_are_noted_with_their_distance)
{
    static const struct {
        const char *ends, *note;
    } cases[] = {
        {"3.,3.,2.,4.;", ""},
        {"3.5,3.,2.,4.;", "a conic whose ends are 0.5 off its equation; the equation is used"},
        {"3.,3.,2.,4.25;", "a conic whose ends are 0.25 off its equation"},
        {"3.125,3.,2.,3.5;", "a conic whose ends are 0.5 off its equation"}};
    for (int i = 0; i < COUNT(cases); i++) {
        char text[100];
        batten_box box;
        iges_text file = iges_begin();
        snprintf(text, sizeof text, "104,1.,0.,1.,-4.,-6.,12.,7.,%s", cases[i].ends);
        iges_add(&file, 104, 1, 0, 0, "00000000", text);
        batten_model *model =
            read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, cases[i].note);
        CHECK(batten_model_box(model, &box));
        CHECK_NEAR(box.high.x, 3, 1e-12);
        CHECK_NEAR(box.high.y, 4, 1e-12);
        CHECK_NEAR(box.low.x, 2, 1e-12);
        CHECK_NEAR(box.low.z, 7, 0);
        batten_model_unref(model);
    }
}
