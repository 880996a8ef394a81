/* Faces on curved surfaces, and what has no loops: measured against what they are. */
#include "exchange/step/boxes.h"

#include <batten/standard.h>

static const double ZERO[] = {0, 0, 0}, X[] = {1, 0, 0}, Z[] = {0, 0, 1}, DOWN[] = {0, 0, -1};

static batten_model *read_item(box_text *text)
{
    batten_model *model = NULL;
    box_context(text, 900);
    box_add(text, "#990=SHAPE_REPRESENTATION('',(#1000),#900);\n");
    const char *file = box_end(text);
    CHECK_OK(read_text(file, BATTEN_FORMAT_STEP, NULL, &model));
    CHECK_INT(batten_model_count(model), 1);
    return model;
}

/* Circles of radius 2 at z = 0 (edge #30) and z = 5 (edge #31), discs on both. */
static void put_can(box_text *text, bool seam)
{
    static const double top[] = {0, 0, 5};
    box_placement(text, 1, ZERO, Z, X);
    box_placement(text, 5, top, Z, X);
    box_placement(text, 9, ZERO, DOWN, X);
    box_add(text, "#20=CIRCLE('',#1,2.);\n#21=CIRCLE('',#5,2.);\n"
                  "#22=CARTESIAN_POINT('',(2.,0.,0.));\n#23=VERTEX_POINT('',#22);\n"
                  "#24=CARTESIAN_POINT('',(2.,0.,5.));\n#25=VERTEX_POINT('',#24);\n"
                  "#30=EDGE_CURVE('',#23,#23,#20,.T.);\n"
                  "#31=EDGE_CURVE('',#25,#25,#21,.T.);\n"
                  "#32=EDGE_CURVE('',#23,#25,#33,.T.);\n#33=LINE('',#22,#34);\n"
                  "#34=VECTOR('',#3,1.);\n"
                  "#40=ORIENTED_EDGE('',*,*,#30,.T.);\n#41=ORIENTED_EDGE('',*,*,#30,.F.);\n"
                  "#42=ORIENTED_EDGE('',*,*,#31,.T.);\n#43=ORIENTED_EDGE('',*,*,#31,.F.);\n"
                  "#44=ORIENTED_EDGE('',*,*,#32,.T.);\n#45=ORIENTED_EDGE('',*,*,#32,.F.);\n"
                  "#50=EDGE_LOOP('',(#41));\n#51=EDGE_LOOP('',(#42));\n"
                  "#52=EDGE_LOOP('',(#40,#44,#43,#45));\n#53=EDGE_LOOP('',(#40));\n"
                  "#54=EDGE_LOOP('',(#43));\n"
                  "#60=FACE_OUTER_BOUND('',#50,.T.);\n#61=FACE_OUTER_BOUND('',#51,.T.);\n"
                  "#62=FACE_OUTER_BOUND('',#52,.T.);\n#63=FACE_BOUND('',#53,.T.);\n"
                  "#64=FACE_BOUND('',#54,.T.);\n"
                  "#70=PLANE('',#9);\n#71=PLANE('',#5);\n"
                  "#72=CYLINDRICAL_SURFACE('',#1,2.);\n"
                  "#80=ADVANCED_FACE('',(#60),#70,.T.);\n"
                  "#81=ADVANCED_FACE('',(#61),#71,.T.);\n");
    box_add(text, "#82=ADVANCED_FACE('',(%s),#72,.T.);\n", seam ? "#62" : "#63,#64");
    box_add(text, "#90=CLOSED_SHELL('',(#80,#81,#82));\n"
                  "#1000=MANIFOLD_SOLID_BREP('can',#90);\n");
}

TEST(a_cylinder_with_and_without_its_seam_is_the_same_solid)
{
    for (int seam = 0; seam < 2; seam++) {
        box_text text;
        put_can(box_begin(&text), seam);
        batten_model *model = read_item(&text);
        const batten_body *body = batten_model_object(model, 0)->body;
        CHECK_INT(batten_body_view(body)->edge_count, 2 + seam);
        const batten_body_measures measures = box_measure(body);
        CHECK(measures.is_closed);
        CHECK_NEAR(measures.volume, 20 * acos(-1), 1e-6);
        CHECK_NEAR(measures.area, 28 * acos(-1), 1e-6);
        batten_model_unref(model);
    }
}

/* The circle of radius 2 at z = 0 (edge #30), the disc below it, and a face above it on surface
 * #72, whose z points down where `down`; its second bound #66 is the vertex #26. */
static batten_model *read_tip(const char *surface, bool down, const char *bounds,
                              const char *more, batten_status due, const char *words)
{
    box_text text;
    box_placement(box_begin(&text), 1, ZERO, down ? DOWN : Z, X);
    box_placement(&text, 5, ZERO, Z, X);
    box_add(&text, "#20=CIRCLE('',#5,2.);\n#22=CARTESIAN_POINT('',(2.,0.,0.));\n"
                   "#23=VERTEX_POINT('',#22);\n#30=EDGE_CURVE('',#23,#23,#20,.T.);\n"
                   "#40=ORIENTED_EDGE('',*,*,#30,.T.);\n#41=ORIENTED_EDGE('',*,*,#30,.F.);\n"
                   "#50=EDGE_LOOP('',(#41));\n#53=EDGE_LOOP('',(#40));\n"
                   "#60=FACE_OUTER_BOUND('',#50,.T.);\n#63=FACE_BOUND('',#53,.T.);\n"
                   "#55=VERTEX_LOOP('',#26);\n#26=VERTEX_POINT('',#27);\n"
                   "#66=FACE_BOUND('',#55,.T.);\n#67=FACE_BOUND('',#53,.F.);\n"
                   "#70=PLANE('',#5);\n#80=ADVANCED_FACE('',(#60),#70,.F.);\n");
    box_add(&text, "#72=%s;\n#81=ADVANCED_FACE('',(%s),#72,.T.);\n%s", surface, bounds, more);
    box_add(&text, "#90=CLOSED_SHELL('',(#80,#81));\n#1000=MANIFOLD_SOLID_BREP('tip',#90);\n");
    box_context(&text, 900);
    box_add(&text, "#990=SHAPE_REPRESENTATION('',(#1000),#900);\n");
    batten_model *model = read_so(box_end(&text), BATTEN_FORMAT_STEP, due, words);
    CHECK_INT(batten_model_count(model), 1);
    return model;
}

/* A third of the base times the height, and the base with pi r l, whichever way it is said. */
TEST(a_cone_with_one_loop_around_it_ends_at_its_apex)
{
    const double pi = acos(-1);
    static const struct {
        const char *surface, *bounds, *more;
        bool down;
        double height;
    } cases[] = {
        {"CONICAL_SURFACE('',#1,2.,0.785398163397448)", "#63", "", true, 2},
        {"CONICAL_SURFACE('',#1,2.,0.785398163397448)", "#63,#66",
         "#27=CARTESIAN_POINT('',(0.,0.,2.));\n", true, 2},
        {"SURFACE_OF_REVOLUTION('',#14,#10)", "#63",
         "#10=AXIS1_PLACEMENT('',#2,#7);\n#11=CARTESIAN_POINT('',(2.,0.,0.));\n"
         "#12=DIRECTION('',(-1.,0.,2.));\n#13=VECTOR('',#12,1.);\n#14=LINE('',#11,#13);\n",
         false, 4},
        {"OFFSET_SURFACE('',#15,1.,.F.)", "#63",
         "#15=CONICAL_SURFACE('',#1,0.585786437626905,0.785398163397448);\n", true, 2},
    };
    for (int k = 0; k < COUNT(cases); k++) {
        batten_model *model = read_tip(cases[k].surface, cases[k].down, cases[k].bounds,
                                       cases[k].more, BATTEN_OK, "");
        const batten_body_measures m = box_measure(batten_model_object(model, 0)->body);
        const double h = cases[k].height;
        CHECK(m.is_closed);
        CHECK_NEAR(m.volume, 4 * pi * h / 3, 1e-6);
        CHECK_NEAR(m.area, 4 * pi + 2 * pi * hypot(2, h), 1e-6);
        CHECK_NEAR(m.centroid[2], h / 4, 1e-6);
        CHECK(m.volume_error < 1e-6);
        batten_model_unref(model);
    }
}

/* The apex is where the surface has it, and the loop has the face on its left there. */
TEST(what_speaks_against_the_apex_of_a_cone_is_noted)
{
    const double pi = acos(-1);
    static const char cone[] = "CONICAL_SURFACE('',#1,2.,0.785398163397448)";
    static const struct {
        const char *vertex, *said;
    } cases[] = {{"#27=CARTESIAN_POINT('',(0.,0.,5.));\n", "is 3 from its apex"},
                 {"#27=DIRECTION('',(0.,0.,5.));\n", "the loop is ignored"}};
    for (int k = 0; k < COUNT(cases); k++) {
        batten_model *model =
            read_tip(cone, true, "#63,#66", cases[k].vertex, BATTEN_OK, cases[k].said);
        CHECK_NEAR(box_measure(batten_model_object(model, 0)->body).volume, 8 * pi / 3, 1e-6);
        batten_model_unref(model);
    }
    /* One that runs around the other way leaves an endless face: it is turned. */
    batten_model *model = read_tip(cone, true, "#67", "", BATTEN_OK, "");
    CHECK_NEAR(box_measure(batten_model_object(model, 0)->body).volume, 8 * pi / 3, 1e-6);
    batten_model_unref(model);
}

TEST(what_goes_on_for_ever_beyond_its_one_loop_is_left_out)
{
    static const struct {
        const char *surface, *more, *said;
    } cases[] = {{"CYLINDRICAL_SURFACE('',#1,2.)", "", "goes around the cylinder"},
                 {"SURFACE_OF_LINEAR_EXTRUSION('',#20,#10)",
                  "#10=VECTOR('',#11,1.);\n#11=DIRECTION('',(0.,0.,1.));\n",
                  "goes around the extrusion"}};
    for (int k = 0; k < COUNT(cases); k++) {
        batten_model *model = read_tip(cases[k].surface, false, "#63", cases[k].more,
                                       BATTEN_PARTLY_READ, cases[k].said);
        const batten_body_measures m = box_measure(batten_model_object(model, 0)->body);
        CHECK(!m.is_closed);
        CHECK_NEAR(m.area, 4 * acos(-1), 1e-6);
        batten_model_unref(model);
    }
}

TEST(a_face_bounded_by_a_vertex_alone_is_the_whole_of_its_surface)
{
    static const struct {
        const char *surface;
        double volume;
        bool inward;
    } cases[] = {
        {"SPHERICAL_SURFACE('',#1,3.)", 113.09733552923255, false},
        {"TOROIDAL_SURFACE('',#1,3.,1.)", 59.217626406535985, false},
        /* 2 pi (3 sqrt(3) - 4 pi / 3) and 2 pi (3 sqrt(3) + 8 pi / 3) */
        {"DEGENERATE_TOROIDAL_SURFACE('',#1,1.,2.,.F.)", 6.329443486644302, true},
        {"DEGENERATE_TOROIDAL_SURFACE('',#1,1.,2.,.T.)", 85.28627869535916, false},
        /* The tube touches the axis: both poles are one point. */
        {"TOROIDAL_SURFACE('',#1,2.,2.)", 157.91367041742974, false},
    };
    for (int k = 0; k < COUNT(cases); k++) {
        box_text text;
        box_placement(box_begin(&text), 1, ZERO, Z, X);
        box_add(&text, "#10=VERTEX_POINT('',#2);\n#11=VERTEX_LOOP('',#10);\n"
                       "#12=FACE_BOUND('',#11,.T.);\n"
                       "#14=CLOSED_SHELL('',(#13));\n"
                       "#1000=MANIFOLD_SOLID_BREP('ball',#14);\n");
        box_add(&text, "#13=ADVANCED_FACE('',(#12),#20,.%c.);\n#20=%s;\n",
                cases[k].inward ? 'F' : 'T', cases[k].surface);
        batten_model *model = read_item(&text);
        const batten_body *body = batten_model_object(model, 0)->body;
        CHECK_INT(batten_body_view(body)->loop_count, 0);
        CHECK_NEAR(box_measure(body).volume, cases[k].volume, 1e-5);
        /* Written with its seam, and that found again on the surface. */
        batten_write_options options = batten_write_defaults();
        options.format = BATTEN_FORMAT_STEP;
        options.no_parameter_curves = true;
        char *data = NULL;
        size_t size = 0;
        CHECK_OK(batten_write_memory(model, &options, NULL, &data, &size));
        batten_model_unref(model);
        CHECK_OK(read_bytes(data, size, BATTEN_FORMAT_STEP, NULL, &model));
        CHECK_NEAR(box_measure(batten_model_object(model, 0)->body).volume, cases[k].volume,
                   1e-5);
        batten_release(data);
        batten_model_unref(model);
    }
}

TEST(a_surface_bounded_by_curves_is_a_face)
{
    box_text text;
    box_placement(box_begin(&text), 1, ZERO, Z, X);
    box_add(&text, "#10=PLANE('',#1);\n#11=CIRCLE('',#1,2.);\n"
                   "#12=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#11);\n"
                   "#13=OUTER_BOUNDARY_CURVE('',(#12),.F.);\n"
                   "#1000=CURVE_BOUNDED_SURFACE('disc',#10,(#13),.F.);\n");
    batten_model *model = read_item(&text);
    const batten_object *object = batten_model_object(model, 0);
    CHECK_TEXT(object->name, "disc");
    CHECK_INT(object->kind, BATTEN_OBJECT_BODY);
    CHECK_NEAR(box_measure(object->body).area, 4 * acos(-1), 1e-6);
    batten_model_unref(model);
}

TEST(triangles_of_ap242_are_meshes)
{
    static const char *const faces[] = {
        "TRIANGULATED_FACE('',#20,4,(),$,(),((1,3,2),(1,2,4),(1,4,3),(2,3,4)))",
        "TRIANGULATED_FACE('',#20,4,(),$,(4,3,2,1),((4,2,3),(4,3,1),(4,1,2),(3,2,1)))",
        "TRIANGULATED_SURFACE_SET('',#20,4,(),(),((1,3,2),(1,2,4),(1,4,3),(2,3,4)))",
        "COMPLEX_TRIANGULATED_FACE('',#20,4,(),$,(),((3,2,1,4,3)),((2,3,4)))"};
    for (int k = 0; k < COUNT(faces); k++)
        for (int wrapped = 0; wrapped < 2; wrapped++) {
            box_text text;
            batten_mesh_facts facts;
            box_begin(&text);
            box_add(&text,
                    "#20=COORDINATES_LIST('',4,((0.,0.,0.),(1.,0.,0.),(0.,1.,0.),"
                    "(0.,0.,1.)));\n#%d=%s;\n%s",
                    wrapped ? 30 : 1000, faces[k],
                    wrapped ? "#1000=TESSELLATED_SOLID('',(#30),$);\n" : "");
            batten_model *model = read_item(&text);
            CHECK_INT(batten_model_object(model, 0)->kind, BATTEN_OBJECT_MESH);
            CHECK_OK(batten_mesh_check(batten_model_object(model, 0)->mesh, &facts));
            CHECK(facts.is_watertight);
            CHECK_NEAR(facts.volume, 1.0 / 6, 1e-15);
            batten_model_unref(model);
        }
}

TEST(sets_and_bare_items_are_objects_of_their_kind)
{
    static const struct {
        const char *item, *name;
        batten_object_kind kind;
    } cases[] = {{"#1000=POLYLINE('p',(#1,#2));\n", "p", BATTEN_OBJECT_CURVE},
                 {"#1000=CARTESIAN_POINT('p',(1.,2.,3.));\n", "p", BATTEN_OBJECT_POINTS},
                 {"#1000=GEOMETRIC_CURVE_SET('s',(#1,#2));\n", "s", BATTEN_OBJECT_POINTS},
                 {"#1000=GEOMETRIC_CURVE_SET('s',(#30));\n#30=POLYLINE('',(#1,#2));\n", "s",
                  BATTEN_OBJECT_CURVE},
                 {"#1000=EDGE_BASED_WIREFRAME_MODEL('w',(#30));\n"
                  "#30=CONNECTED_EDGE_SET('',(#31));\n#31=EDGE_CURVE('',#32,#33,#34,.T.);\n"
                  "#32=VERTEX_POINT('',#1);\n#33=VERTEX_POINT('',#2);\n"
                  "#34=POLYLINE('',(#1,#2));\n",
                  "w", BATTEN_OBJECT_CURVE}};
    for (int k = 0; k < COUNT(cases); k++) {
        box_text text;
        box_begin(&text);
        box_add(&text,
                "#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=CARTESIAN_POINT('',(1.,0.,0.));\n"
                "%s",
                cases[k].item);
        batten_model *model = read_item(&text);
        CHECK_INT(batten_model_object(model, 0)->kind, cases[k].kind);
        CHECK_TEXT(batten_model_object(model, 0)->name, cases[k].name);
        batten_model_unref(model);
    }
}
