/* What is wrong in files: left out with a note, or mended with a note. */
#include "exchange/step/read/bent_box.h"

TEST(P1_a_face_with_a_bad_reference_is_left_out)
{
    static const struct {
        const char *instead, *words;
        int faces;
    } cases[] = {
        {"#154=ADVANCED_FACE('side 3',(#144),#9999,.T.);\n", "#9999", 5},
        {"#154=ADVANCED_FACE('side 3',(#9998),#234,.T.);\n", "#9998", 5},
        {"#154=ADVANCED_FACE('side 3',(#134),#234,.T.);\n", "where a FACE_BOUND is expected",
         5},
        {"#154=ADVANCED_FACE('side 3',(#144),#1,.T.);\n", "is not a surface", 5},
        {"#154=ORIENTED_FACE('side 3',*,#154,.T.);\n", "refers to itself", 5},
        {"#144=FACE_BOUND('',#144,.T.);\n", "where a loop is expected", 5},
        {"#113=ORIENTED_EDGE('',*,*,#113,.T.);\n", "where an EDGE_CURVE is expected", 5},
        {"#12=LINE('',#4,#44);\n", "", 3},
        {"#81=EDGE_CURVE('',#9,#10,#9997,.T.);\n", "could not be read before", 4},
        {"#181=CLOSED_SHELL('',(#151,#151,#152,#153,#154,#155,#156));\n", "twice of one", 6},
        {"#181=CLOSED_SHELL('',(#151,#152,#153,#154,#155,#156,#9996));\n", "#9996", 6},
        {"#181=CLOSED_SHELL('',(#151,#9996,'',#152,#153,#154,#155,#156));\n", "#9996", 6}};
    for (int k = 0; k < COUNT(cases); k++)
        check_read(box_with(cases[k].instead), BATTEN_PARTLY_READ, cases[k].words,
                   cases[k].faces, false);
}

TEST(P1_a_solid_with_a_bad_shell_is_left_out)
{
    check_none(box_with("#1000=MANIFOLD_SOLID_BREP('box',#1000);\n"));
    check_none(box_with("#1000=MANIFOLD_SOLID_BREP('box',#9999);\n"));
    check_none(box_with("#181=ORIENTED_CLOSED_SHELL('',*,#181,.T.);\n"));
    check_none(box_with("#181=CLOSED_SHELL('',());\n"));
    check_none(box_with("#1000=BANANA('box',#181);\n"));
}

TEST(P2_arguments_of_faces_that_do_not_fit_are_named)
{
    static const struct {
        const char *instead, *words;
    } cases[] = {{"#154=ADVANCED_FACE('side 3',(#144),#234);\n", "argument 4"},
                 {"#154=ADVANCED_FACE('side 3',(),#234,.T.);\n", "no bounds"},
                 {"#154=ADVANCED_FACE((#144),#234,.T.);\n", "argument"},
                 {"#144=FACE_OUTER_BOUND('',#134,'x');\n", "argument 3"},
                 {"#134=EDGE_LOOP('',());\n", "the loop has no edges"},
                 {"#134=EDGE_LOOP('',$);\n", "argument 2"},
                 {"#134=EDGE_LOOP('',(#113,#114,#115));\n", "is a gap of 1"}};
    for (int k = 0; k < COUNT(cases); k++)
        check_read(box_with(cases[k].instead), BATTEN_PARTLY_READ, cases[k].words, 5, false);
}

TEST(P6_a_file_without_units_is_in_millimetres_and_says_so)
{
    const char *cases[] = {"#900=GEOMETRIC_REPRESENTATION_CONTEXT('','',3);\n",
                           "#900=LINE('',#1,#41);\n", "#901=BANANA();\n",
                           "#990=SHAPE_REPRESENTATION('',(#1000),$);\n"};
    for (int k = 0; k < COUNT(cases); k++)
        check_read(box_with(cases[k]), BATTEN_OK, "millimetres are assumed", 6, true);
}

TEST(P6_units_of_all_kinds_are_understood)
{
    static const struct {
        const char *unit;
        double metres;
    } cases[] = {
        {"#901=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));\n", 1},
        {"#901=SI_UNIT(*,.CENTI.,.METRE.);\n", 0.01},
        {"#901=(CONVERSION_BASED_UNIT('FOOT',#910)LENGTH_UNIT()NAMED_UNIT($));\n"
         "#910=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(12.),#911);\n"
         "#911=(CONVERSION_BASED_UNIT('INCH',#912)LENGTH_UNIT()NAMED_UNIT($));\n"
         "#912=(LENGTH_MEASURE_WITH_UNIT()MEASURE_WITH_UNIT(LENGTH_MEASURE(2.54),#913));"
         "\n#913=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.CENTI.,.METRE.));\n",
         0.3048},
        {"#901=(CONVERSION_BASED_UNIT('INCH',#9999)LENGTH_UNIT()NAMED_UNIT($));\n", 0.0254},
        {"#901=(CONVERSION_BASED_UNIT('UNKNOWN',#910)LENGTH_UNIT()NAMED_UNIT($));\n"
         "#910=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(2.),#901);\n",
         0.001}};
    for (int k = 0; k < COUNT(cases); k++) {
        batten_model *model = NULL;
        CHECK_OK(read_text(box_with(cases[k].unit), BATTEN_FORMAT_STEP, NULL, &model));
        CHECK_BITS(batten_model_unit_metres(model), cases[k].metres);
        batten_model_unref(model);
    }
}

TEST(P6_a_unit_of_nothing_or_less_of_another_goes_by_its_name_and_says_so)
{
    static const struct {
        const char *name, *value, *words;
        double metres;
    } cases[] = {
        {"INCH", "-25.4", "'INCH' has the factor -25.4; by its name 0.0254 m is taken", 0.0254},
        {"INCH", "0.", "'INCH' has the factor 0; by its name 0.0254 m is taken", 0.0254},
        {"ELL", "-1.", "'ELL' has the factor -1; it is ignored", 0.001},
        {"INCH", "2.", "", 0.002}};
    for (int k = 0; k < COUNT(cases); k++) {
        char unit[300];
        snprintf(unit, sizeof unit,
                 "#901=(CONVERSION_BASED_UNIT('%s',#910)LENGTH_UNIT()NAMED_UNIT($));\n"
                 "#910=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(%s),#911);\n"
                 "#911=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n",
                 cases[k].name, cases[k].value);
        batten_model *model = read_noting(box_with(unit), BATTEN_FORMAT_STEP, cases[k].words);
        CHECK_BITS(batten_model_unit_metres(model), cases[k].metres);
        batten_model_unref(model);
    }
}

TEST(P6_representations_without_units_stand_beside_others_in_metres)
{
    batten_model *model = NULL;
    const char *file = box_with("#901=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));\n"
                                "#1001=POLYLINE('line',(#1,#2));\n"
                                "#991=SHAPE_REPRESENTATION('',(#1001),$);\n");
    CHECK_OK(read_text(file, BATTEN_FORMAT_STEP, NULL, &model));
    CHECK_INT(batten_model_count(model), 2);
    CHECK_BITS(batten_model_unit_metres(model), 1);
    const batten_box box = batten_curve_box(batten_model_object(model, 1)->curve);
    CHECK_NEAR(box.high.x, 0.001, 1e-18);
    batten_model_unref(model);
}

TEST(an_edge_that_runs_against_its_curve_is_turned_with_a_note)
{
    check_read(box_with("#81=EDGE_CURVE('',#9,#10,#61,.F.);\n"), BATTEN_OK,
               "the file says otherwise", 6, true);
    check_read(
        box_with("#61=B_SPLINE_CURVE_WITH_KNOTS('',1,(#2,#1),.UNSPECIFIED.,.F.,.F.,(2,2),"
                 "(0.,1.),.UNSPECIFIED.);\n"),
        BATTEN_OK, "the file says otherwise", 6, true);
}

TEST(gaps_between_curves_and_vertices_are_closed_when_they_are_small)
{
    check_read(
        box_with("#61=POLYLINE('',(#1300,#1301));\n#1300=CARTESIAN_POINT('',(0.,1E-5,0.));\n"
                 "#1301=CARTESIAN_POINT('',(1.,0.,0.));\n"),
        BATTEN_OK, "its ends are moved", 6, true);
    check_read(
        box_with("#61=POLYLINE('',(#1300,#1301));\n#1300=CARTESIAN_POINT('',(0.,1E-3,0.));\n"
                 "#1301=CARTESIAN_POINT('',(1.,0.,0.));\n"),
        BATTEN_OK, "kept so", 6, true);
}

TEST(an_edge_whose_curve_is_far_from_its_vertices_is_left_out_with_its_faces)
{
    /* Side 3 and side 1 meet in #84, of which #16 is an end; it is 1 long. */
    check_read(box_with("#8=CARTESIAN_POINT('',(1.,1.,-2E9));\n"), BATTEN_PARTLY_READ,
               "its curve, 1 large, misses its vertices by", 3, false);
}

TEST(a_point_far_off_all_vertices_does_not_make_the_shape_large)
{
    /* The origin of a plane: with the accuracy of 1e15 all vertices would be one. */
    check_read(box_with("#210=CARTESIAN_POINT('',(1E15,0.,0.));\n"), BATTEN_OK, "", 6, true);
}

TEST(a_body_smaller_than_the_accuracy_is_left_out)
{
    /* A vertex so far off that no accuracy better than 1 makes sense. */
    check_none(box_with("#1300=VERTEX_POINT('',#1301);\n"
                        "#1301=CARTESIAN_POINT('',(1E12,0.,0.));\n"));
    CHECK_TEXT(batten_message(), "t: its 1 entity could not be read");
}

TEST(a_surface_of_one_point_is_left_out)
{
    static const char *const surfaces[] = {
        "#1300=BEZIER_SURFACE('',1,1,((#1,#1),(#1,#1)),.UNSPECIFIED.,.F.,.F.,.F.);\n",
        /* The offset is so far off that its points are one. */
        "#1300=OFFSET_SURFACE('',#1301,1E154,.F.);\n"
        "#1301=BEZIER_SURFACE('',1,1,((#1,#2),(#3,#4)),.UNSPECIFIED.,.F.,.F.,.F.);\n"};
    for (int k = 0; k < COUNT(surfaces); k++) {
        char text[300];
        snprintf(text, sizeof text,
                 "#1000=BANANA('box',#181);\n#990=SHAPE_REPRESENTATION('',(#1300),#900);\n%s",
                 surfaces[k]);
        check_none(box_with(text));
    }
}

TEST(vertices_that_nearly_coincide_become_one)
{
    /* Edge #81 ends in a vertex of its own, beside #10. */
    check_read(box_with("#81=EDGE_CURVE('',#9,#1300,#61,.T.);\n#1300=VERTEX_POINT('',#1301);\n"
                        "#1301=CARTESIAN_POINT('',(1.,0.,1E-7));\n"),
               BATTEN_OK, "their vertices are taken as one", 6, true);
    check_read(box_with("#81=EDGE_CURVE('',#9,#1300,#61,.T.);\n#1300=VERTEX_POINT('',#1301);\n"
                        "#1301=CARTESIAN_POINT('',(1.,0.,0.01));\n"),
               BATTEN_PARTLY_READ, "is a gap of 0.01", 4, false);
}

TEST(a_closed_shell_with_a_rim_is_noted)
{
    check_read(box_with("#181=CLOSED_SHELL('',(#151,#152,#153,#154,#155));\n"), BATTEN_OK,
               "4 of its edges are of one face only", 5, true);
}

TEST(S1_lists_that_are_followed_over_and_over_are_refused)
{
    /* A thousand faces with one loop of a thousand edges each: a million uses. */
    enum { MANY = 1000 };
    box_text text;
    batten_model *model = NULL;
    box_shell(box_begin(&text), 1, ORIGIN, 1, 0);
    box_add(&text, "#2000=EDGE_LOOP('',(#101");
    for (int k = 1; k < MANY; k++)
        box_add(&text, ",#101");
    box_add(&text, "));\n#2001=FACE_BOUND('',#2000,.T.);\n#2002=OPEN_SHELL('',(#151");
    for (int k = 0; k < MANY; k++)
        box_add(&text, ",#%d", 3000 + k);
    box_add(&text, "));\n");
    for (int k = 0; k < MANY; k++)
        box_add(&text, "#%d=ADVANCED_FACE('',(#2001),#231,.T.);\n", 3000 + k);
    box_context(&text, 900);
    box_add(&text, "#990=SHAPE_REPRESENTATION('',(#2002),#900);\n");
    const char *file = box_end(&text);
    CHECK_STATUS(read_text(file, BATTEN_FORMAT_STEP, NULL, &model), BATTEN_PARTLY_READ);
    CHECK_INT(batten_body_view(batten_model_object(model, 0)->body)->face_count, 1);
    batten_model_unref(model);
}

TEST(F2_a_step_file_cut_anywhere_is_never_a_quiet_whole)
{
    const char *file = box_with("");
    const size_t size = strlen(file), step = size / (size_t)test_cases(40) + 1;
    for (size_t end = 1; end + 20 < size; end += step) {
        batten_model *model = NULL;
        CHECK(read_bytes(file, end, BATTEN_FORMAT_STEP, NULL, &model) != BATTEN_OK);
        batten_model_unref(model);
    }
}

TEST(an_instance_beyond_what_numbers_tell_apart_is_written_as_far_as_it_goes)
{
    /* A plane that nearly holds the axis that it stands on, moved by 2^63: all its points fall
     * on one another, and edges lie any number of turns around it. */
    batten_write_options options = batten_write_defaults();
    batten_model *model = NULL;
    char *data = NULL;
    size_t size = 0;
    options.format = BATTEN_FORMAT_STEP;
    const char *file = box_with("#214=CARTESIAN_POINT('',(-2.,1.,0.));\n"
                                "#215=DIRECTION('',(4294967296.,1.,0.));\n"
                                "#990=SHAPE_REPRESENTATION('part',(#1000),#900);\n"
                                "#701=CARTESIAN_POINT('',(0.,0.,0.));\n"
                                "#700=AXIS2_PLACEMENT_3D('',#701,$,$);\n"
                                "#711=CARTESIAN_POINT('',(9223372036854775808.,0.,0.));\n"
                                "#712=DIRECTION('',(0.,0.,1.));\n"
                                "#740=DIRECTION('',(0.,1.,0.));\n"
                                "#741=DIRECTION('',(1.,0.,0.));\n"
                                "#731=CARTESIAN_TRANSFORMATION_OPERATOR_3D('',#740,#741,#711,"
                                "255.,#712);\n"
                                "#749=REPRESENTATION_MAP(#700,#990);\n"
                                "#750=MAPPED_ITEM('here',#749,#731);\n"
                                "#800=SHAPE_REPRESENTATION('whole',(#750),#900);\n");
    CHECK_OK(read_text(file, BATTEN_FORMAT_STEP, NULL, &model));
    CHECK_OK(batten_write_memory(model, &options, NULL, &data, &size));
    batten_release(data);
    batten_model_unref(model);
}
