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

TEST(a_face_bounded_by_a_vertex_alone_is_the_whole_of_its_surface)
{
    static const struct {
        const char *surface;
        double volume;
    } cases[] = {{"SPHERICAL_SURFACE('',#1,3.)", 36}, {"TOROIDAL_SURFACE('',#1,3.,1.)", 0}};
    for (int k = 0; k < COUNT(cases); k++) {
        box_text text;
        box_placement(box_begin(&text), 1, ZERO, Z, X);
        box_add(&text, "#10=VERTEX_POINT('',#2);\n#11=VERTEX_LOOP('',#10);\n"
                       "#12=FACE_BOUND('',#11,.T.);\n"
                       "#13=ADVANCED_FACE('',(#12),#20,.T.);\n"
                       "#14=CLOSED_SHELL('',(#13));\n"
                       "#1000=MANIFOLD_SOLID_BREP('ball',#14);\n");
        box_add(&text, "#20=%s;\n", cases[k].surface);
        batten_model *model = read_item(&text);
        const batten_body *body = batten_model_object(model, 0)->body;
        CHECK_INT(batten_body_view(body)->loop_count, 0);
        const double pi = acos(-1);
        CHECK_NEAR(box_measure(body).volume, k ? 6 * pi * pi : 36 * pi, 1e-5);
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
