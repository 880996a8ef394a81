#include "design/evaluate.h"
#include "design/expect.h"

/* The features that take equations: what they make, and what they refuse. */

static const char before[] = "";

TEST(functions_and_parametric_curves_have_the_points_of_their_formulas)
{
    static const expect_row rows[] = {
        {"{function: y = x^2, x: [0, 2]}", BATTEN_OK,
         "objects 1;degree 5;at 0.5 1 1 0;at 1 2 4 0;error 1e-3"},
        {"{function: x = 0.5*y, y: [0, 2]}", BATTEN_OK, "at 0.5 0.5 1 0;at 1 1 2 0"},
        {"{function: z = x*y, x: [0, 2], y: [1, 3]}", BATTEN_OK, "at 0.5 0.5 1 2 2;error 1e-3"},
        {"{parametric: [2*cos(t), 2*sin(t), 0.5*t], t: [0, 4]}", BATTEN_OK,
         "within 3e-3;along 2 0 0 0 0 0 1;length 8.246211251235321;at 0 2 0 0"},
        {"{parametric: [u, v, u + v], u: [0, 1], v: [0, 1]}", BATTEN_OK, "at 1 1 1 1 2"},
        {"{function: y = 1/x, x: [-1, 1]}", BATTEN_OUT_OF_DOMAIN, "no finite value"},
        {"{function: y = abs(x), x: [-1, 1]}", BATTEN_OK,
         "notes a corner, without a derivative"},
        {"{function: x*x, x: [-1, 1]}", BATTEN_BAD_ARGUMENT, "does not begin with 'y ='"},
        {"{function: y = x}", BATTEN_BAD_ARGUMENT, "write x: [a, b]"},
        {"{function: y = x, x: [0, 1], y: [0, 1]}", BATTEN_BAD_ARGUMENT,
         "y is the value of the function"},
        {"{parametric: [t, t], u: [0, 1]}", BATTEN_BAD_ARGUMENT, "a curve needs t: [a, b]"},
        {"{parametric: [t], t: [0, 1]}", BATTEN_BAD_ARGUMENT, "1 coordinates"},
        {"{parametric: [t, s], t: [0, 1]}", BATTEN_BAD_FORMAT, "nothing is named 's'"},
    };
    EXPECT(before, rows);
}

TEST(implicit_curves_come_whole_with_their_points)
{
    static const expect_row rows[] = {
        {"{implicit-curve: x^2 + y^2 = 4, x: [-2, 2], y: [-2, 2]}", BATTEN_OK,
         "objects 1;closed 1;within 3e-3;distance 2 0 0 0;error 1e-3"},
        {"{implicit-curve: x^2 + y^2 = 4, x: [0, 3], y: [-3, 3]}", BATTEN_OK,
         "objects 1;closed 0;within 3e-3;length 6.283185307"},
        {"{implicit-curve: x*y = 0, x: [-1, 1], y: [-1, 1]}", BATTEN_OK,
         "objects 3;notes a node, where branches cross, at (0, 0, 0)"},
        {"{implicit-curve: [x^2 + y^2 = 1, z = 1], x: [-2, 2], y: [-2, 2], z: [0, 2]}",
         BATTEN_OK, "objects 1;within 3e-3;distance 1 0 0 1"},
        {"{implicit-curve: x^2 + y^2 = -1, x: [-1, 1], y: [-1, 1]}", BATTEN_BAD_ARGUMENT,
         "no point of the curve; that is proved"},
        {"{implicit-curve: (x - y)^2 = 0, x: [-1, 1], y: [-1, 1]}", BATTEN_BAD_ARGUMENT,
         "no part of the curve could be shown"},
        {"{implicit-curve: y = 1/x, x: [-1, 1], y: [-2, 2], within: 0.001}", BATTEN_OK,
         "objects 2;notes INCOMPLETE"},
        {"{implicit-curve: x = y, x: [-1, 1], y: [-2, 2], z: [0, 1]}", BATTEN_BAD_ARGUMENT,
         "a range of z has no use"},
        {"{implicit-curve: [x = y, y = z], x: [-1, 1], y: [-2, 2]}", BATTEN_BAD_ARGUMENT,
         "the range of z is missing"},
        {"{implicit-curve: [x, y, z], x: [-1, 1], y: [-2, 2]}", BATTEN_BAD_ARGUMENT,
         "3 equations"},
    };
    EXPECT(before, rows);
}

TEST(helices_rise_by_their_pitch_in_a_turn)
{
    static const expect_row rows[] = {
        {"{helix: 2, pitch: 1, turns: 3}", BATTEN_OK,
         "objects 1;within 3e-3;along 2 0 0 0 0 0 1;at 0 2 0 0;at 1 2 0 3;at 0.25 0 -2 "
         "0.75;length 37.81828967254955"},
        {"{helix: 2, end-radius: 1, pitch: 1, turns: 2}", BATTEN_OK, "within 3e-3;at 1 1 0 2"},
        {"{helix: 1, pitch: 1, turns: 1, axis: x, from: y, at: [1, 0, 0]}", BATTEN_OK,
         "within 3e-3;at 0 1 1 0;at 1 2 1 0"},
        {"{helix: 0, pitch: 1, turns: 1}", BATTEN_BAD_ARGUMENT, "radii of 0 and 0"},
        {"{helix: 1, pitch: 1, turns: 0}", BATTEN_BAD_ARGUMENT, "0 turns"},
    };
    EXPECT(before, rows);
}

TEST(equations_know_the_parameters_of_the_design)
{
    batten_design *design = NULL;
    const batten_status status =
        evaluate_design("batten: 1\nunits: m\nparameters: {r: 300 mm, n: 2, x: 4}\nfeatures:\n"
                        "  a: {function: y = n*x + r, x: [0, 1]}\n",
                        "a", NULL, &design);
    double p[3];
    if (status == BATTEN_OK) {
        const batten_model *model = batten_design_result(design, "a")->value;
        CHECK_OK(batten_curve_evaluate(batten_model_object(model, 0)->curve, 1, 0, p));
        CHECK_NEAR(p[1], 2.3, 1e-12);
    } else {
        CHECK_INT(status, BATTEN_OUT_OF_MEMORY);
    }
    batten_design_free(design);
}

TEST(a_feature_hides_the_axis_of_its_name)
{
    batten_design *design = NULL;
    const batten_status status =
        evaluate_design("batten: 1\nunits: m\nfeatures:\n"
                        "  z: {points: [[0, 0, 5], [1, 0, 5], [2, 1, 5]]}\n"
                        "  a: {polyline: z}\n",
                        "a", NULL, &design);
    if (status == BATTEN_OK) {
        const batten_model *model = batten_design_result(design, "a")->value;
        CHECK_INT(batten_curve_point_count(batten_model_object(model, 0)->curve), 3);
    } else {
        CHECK_INT(status, BATTEN_OUT_OF_MEMORY);
    }
    batten_design_free(design);
}

static const char hiding[] = "  p: {points: [[0, 0], [1, 0]]}\n";

static const expect_row of_remarks[] = {
    {"{parametric: [abs(t - 1), t], t: [0, 2]}", BATTEN_OK,
     "notes a corner, without a derivative, at (0, 1, 0)"},
    {"{parametric: [t^2, t^3, 5], t: [-1, 1]}", BATTEN_OK,
     "notes a halt, where the derivative may vanish, at (;at 0 1 -1 5;at 1 1 1 5"},
    {"{implicit-curve: x^2 + y^2 = 0, x: [-1, 1], y: [-1, 1]}", BATTEN_OK,
     "objects 1;kind points;data 0 0 0 0;notes an isolated point at (0, "
     "0, 0)"},
    {"{implicit-curve: y^2 = x^3, x: [-1, 1], y: [-1, 1]}", BATTEN_OK,
     "notes a singular point at (0, 0, 0)"},
    /* Seven nodes along a line: the first six are shown. */
    {"{implicit-curve: y*sin(3.141592653589793*x) = 0, x: [0.5, 7.5], y: [-1, 1]}", BATTEN_OK,
     "notes at (1, 0, 0);notes at (6, 0, 0);notes 1 more special points"},
    {"{parametric: [u, v, u*v], u: [1, 2], v: [3, 5]}", BATTEN_OK,
     "at 0 0 1 3 3;at 1 0 2 3 6;at 0 1 1 5 5;at 1 1 2 5 10;error 1e-3"},
    {"{parametric: [u, v], u: [0, 1], v: [0, 1]}", BATTEN_BAD_ARGUMENT,
     "2 coordinates; a surface has 3"},
    {"{parametric: [t, t, t, t], t: [0, 1]}", BATTEN_BAD_ARGUMENT,
     "4 coordinates; a curve has 2 or 3"},
    {"{parametric: [u, v, u], u: [0, 1]}", BATTEN_BAD_ARGUMENT,
     "a surface needs u: [a, b] and v: [c, d]"},
    {"{parametric: [u, v, u], v: [0, 1]}", BATTEN_BAD_ARGUMENT, "a surface needs u: [a, b]"},
    {"{parametric: [t, t], t: [0, 1], v: [0, 1]}", BATTEN_BAD_ARGUMENT, "a curve needs t"},
    {"{parametric: [t, 2], t: [3, 7]}", BATTEN_OK, "at 0 3 2 0;at 1 7 2 0;length 4"},
    {"{function: x = y, x: [0, 1], y: [0, 1]}", BATTEN_BAD_ARGUMENT,
     "x is the value of the function; a range of it has no use here"},
    {"{function: w = y, y: [0, 1]}", BATTEN_BAD_ARGUMENT, "'w = y' does not begin with"},
    {"{function: z = x, x: [0, 1]}", BATTEN_BAD_ARGUMENT,
     "the range of y is missing; write y: [a, b]"},
    {"{function: z = x, x: [0, 1], y: [0, 1], within: 0}", BATTEN_BAD_ARGUMENT, "0"},
    {"{function: y = (x, x: [0, 1]}", BATTEN_BAD_FORMAT, "\""},
    {"{helix: 2, end-radius: 1, pitch: -1, turns: 1}", BATTEN_OK, "at 0 2 0 0;at 1 1 0 -1"},
    {"{helix: 1, pitch: 1, turns: 1, within: 1e-6}", BATTEN_OK, "error 1e-6"},
};

TEST(what_is_special_about_curves_of_equations_is_remarked_with_its_place)
{
    EXPECT(hiding, of_remarks);
}

TEST(a_parameter_that_a_variable_hides_is_remarked)
{
    batten_design *design = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(9, &notes));
    CHECK_OK(evaluate_design("batten: 1\nunits: m\nparameters: {x: 4, t: 3, n: 2}\nfeatures:\n"
                             "  a: {function: y = n*x, x: [0, 1]}\n",
                             "a", notes, &design));
    bool said = batten_notes_dropped(notes) > 0; /* where memory failed */
    for (int i = 0; i < batten_notes_count(notes); i++) {
        said |= strcmp(batten_notes_at(notes, i)->text,
                       "x is the variable here, not the parameter x of the design") == 0;
        CHECK(!strstr(batten_notes_at(notes, i)->text, "parameter n"));
        CHECK(!strstr(batten_notes_at(notes, i)->text, "parameter t"));
    }
    CHECK(said);
    batten_design_free(design);
    batten_notes_free(notes);
}
