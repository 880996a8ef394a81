#include "exchange/step/references.h"
#include "exchange/step/step.h"

static batten_model *curve_model(double unit)
{
    test_random random = test_random_begin("curve_model");
    batten_curve *curve = random_curve(&random);
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(unit, &model));
    add_curve(model, "keel", curve);
    batten_curve_unref(curve);
    return model;
}

TEST(the_unit_stands_in_the_context)
{
    const struct {
        double unit;
        const char *words;
    } cases[] = {
        {1, "(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT($,.METRE.))"},
        {0.001, "SI_UNIT(.MILLI.,.METRE.)"},
        {0.01, "SI_UNIT(.CENTI.,.METRE.)"},
        {1000, "SI_UNIT(.KILO.,.METRE.)"},
        {1e-6, "SI_UNIT(.MICRO.,.METRE.)"},
        {0, "SI_UNIT(.MILLI.,.METRE.)"},
        {0.0254, "(CONVERSION_BASED_UNIT('INCH',#"},
        {0.3048, "(CONVERSION_BASED_UNIT('FOOT',#"},
        {0.0254, "LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.0254),#"},
        {2.5, "LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(2.5),#"},
        {2.5, "(CONVERSION_BASED_UNIT('UNIT',#"},
        {2.5, "DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        batten_model *model = curve_model(cases[i].unit);
        const char *text = step_text(model, NULL);
        step_check(text);
        step_check_references(text);
        CHECK_CONTAINS(text, cases[i].words);
        batten_model_unref(model);
    }
}

TEST(the_accuracy_is_a_millionth_of_a_metre_or_what_is_asked)
{
    batten_model *model = curve_model(0.001);
    CHECK_CONTAINS(step_text(model, NULL),
                   "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.001),#");
    batten_write_options options = batten_write_defaults();
    char *data = NULL;
    size_t size = 0;
    options.format = BATTEN_FORMAT_STEP;
    options.tolerance = 0.25;
    options.date = "2026-11-21T10:25:00";
    options.name = "it's";
    CHECK_OK(batten_write_memory(model, &options, NULL, &data, &size));
    CHECK_CONTAINS(data, "LENGTH_MEASURE(0.25)");
    CHECK_CONTAINS(data, "FILE_NAME('it''s','2026-11-21T10:25:00',(''),(''),'Batten ");
    CHECK_CONTAINS(data, "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));");
    batten_release(data);
    batten_model_unref(model);
}

TEST(faces_and_curves_have_representations_of_their_own)
{
    test_random random = test_random_begin(__func__);
    batten_model *model = curve_model(1);
    const char *text = step_text(model, NULL);
    CHECK_INT(step_count(text, "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION"), 1);
    CHECK_INT(step_count(text, "SHAPE_REPRESENTATION"), 0);
    batten_surface *surface = random_surface(&random);
    add_surface(model, "side", surface);
    text = step_text(model, NULL);
    step_check(text);
    CHECK_INT(step_count(text, "MANIFOLD_SURFACE_SHAPE_REPRESENTATION"), 1);
    CHECK_INT(step_count(text, "SHAPE_REPRESENTATION"), 1);
    CHECK_INT(step_count(text, "SHAPE_REPRESENTATION_RELATIONSHIP"), 2);
    CHECK_INT(step_count(text, "SHAPE_DEFINITION_REPRESENTATION"), 1);
    CHECK_INT(step_count(text, "STYLED_ITEM"), 0);
    batten_surface_unref(surface);
    batten_model_unref(model);
}

TEST(points_are_written_and_tables_are_not)
{
    const double points[] = {1, 2, 3, 4, 5, 6};
    const batten_table_point side = {0, 1, 2, -1};
    const batten_table_station station = {"0", 0, 1, &side};
    batten_offset_table *offsets = NULL;
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_notes_create(4, &notes));
    CHECK_OK(batten_offset_table_create(1, 0, NULL, 1, &station, &offsets));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "data",
                                                      .kind = BATTEN_OBJECT_POINTS,
                                                      .point_count = 2,
                                                      .points = points}));
    CHECK_OK(batten_model_add(model,
                              &(batten_object){.name = "none", .kind = BATTEN_OBJECT_POINTS}));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "table",
                                                      .kind = BATTEN_OBJECT_OFFSET_TABLE,
                                                      .offset_table = offsets}));
    const char *text = step_text(model, notes);
    step_check(text);
    CHECK_INT(step_count(text, "GEOMETRIC_CURVE_SET"), 1);
    CHECK_CONTAINS(text, "GEOMETRIC_CURVE_SET('data',(#");
    CHECK(batten_notes_dropped(notes) ||
          has_note(notes, "left out: STEP files hold points, curves"));
    batten_notes_free(notes);
    batten_offset_table_unref(offsets);
    batten_model_unref(model);
}

/* ISO 10303-46, marker_type: dot, x, plus, asterisk, ring, square, triangle. */
TEST(coloured_points_have_a_marker_that_the_standard_knows)
{
    static const double points[] = {0, 0, 0, 1, 2, 3};
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(model, &(batten_object){.has_colour = true,
                                                      .colour = {1, 0.5, 0},
                                                      .kind = BATTEN_OBJECT_POINTS,
                                                      .point_count = 2,
                                                      .points = points}));
    const char *text = step_text(model, NULL);
    step_check(text);
    CHECK_CONTAINS(text, "POINT_STYLE('',MARKER_TYPE(.DOT.),POSITIVE_LENGTH_MEASURE(1.),#");
    batten_model_unref(model);
}

TEST(colours_are_styles_of_faces_and_curves)
{
    test_random random = test_random_begin(__func__);
    batten_surface *surface = random_surface(&random);
    batten_curve *curve = random_curve(&random);
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(model, &(batten_object){.has_colour = true,
                                                      .colour = {1, 0.5, 0},
                                                      .kind = BATTEN_OBJECT_SURFACE,
                                                      .surface = surface}));
    CHECK_OK(batten_model_add(model, &(batten_object){.has_colour = true,
                                                      .colour = {0, 0.25, 0},
                                                      .kind = BATTEN_OBJECT_CURVE,
                                                      .curve = curve}));
    const char *text = step_text(model, NULL);
    step_check(text);
    CHECK_CONTAINS(text, "COLOUR_RGB('',1.,0.5,0.)");
    CHECK_CONTAINS(text, "COLOUR_RGB('',0.,0.25,0.)");
    CHECK_INT(step_count(text, "STYLED_ITEM"), 2);
    CHECK_INT(step_count(text, "CURVE_STYLE"), 1);
    CHECK_INT(step_count(text, "SURFACE_STYLE_USAGE"), 1);
    batten_model_unref(model);
    batten_curve_unref(curve);
    batten_surface_unref(surface);
}

/* ---- assemblies ---- */

/* By 30 degrees about (1, 2, 2) / 3: a map without a zero. */
static batten_affine skew_turn(void)
{
    const double c = sqrt(0.75), s = 0.5, n[3] = {1. / 3, 2. / 3, 2. / 3};
    const double cross[3][3] = {{0, -n[2], n[1]}, {n[2], 0, -n[0]}, {-n[1], n[0], 0}};
    batten_affine turn = {.t = {5, -7, 11}};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            turn.m[i][k] = c * (i == k) + s * cross[i][k] + (1 - c) * n[i] * n[k];
    return turn;
}

TEST(only_turns_and_moves_are_places_and_no_reflections)
{
    const batten_affine turn = skew_turn();
    CHECK(bat_step_can_place(&turn));
    for (int k = 0; k < 3; k++)
        for (int l = 0; l < 3; l++) {
            batten_affine other = turn;
            for (int i = 0; i < 3;
                 i++) /* columns change places: a reflection, or the other diagonal */
                other.m[i][k] = turn.m[i][l], other.m[i][l] = turn.m[i][k];
            CHECK(bat_step_can_place(&other) == (k == l));
            other = turn;
            other.m[k][l] += 1e-11;
            CHECK(!bat_step_can_place(&other));
            other.m[k][l] = turn.m[k][l] + 1e-13;
            CHECK(bat_step_can_place(&other));
            other.m[k][l] = NAN;
            CHECK(!bat_step_can_place(&other));
        }
    for (int signs = 0; signs < 8; signs++) {
        batten_affine other = turn;
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < 3; k++)
                other.m[i][k] *= signs >> k & 1 ? -1 : 1;
        const int reversed = (signs & 1) + (signs >> 1 & 1) + (signs >> 2);
        CHECK(bat_step_can_place(&other) == (reversed % 2 == 0));
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < 3; k++)
                other.m[i][k] *= 1.5;
        CHECK(!bat_step_can_place(&other));
    }
    for (int k = 0; k < 3; k++) { /* the three cyclic orders of the axes, and what reflects */
        batten_affine cyclic = {.t = {0}}, odd = {.t = {0}};
        for (int i = 0; i < 3; i++) {
            cyclic.m[i][(i + k) % 3] = 1;
            odd.m[i][(k + 3 - i) % 3] = 1;
        }
        CHECK(bat_step_can_place(&cyclic));
        CHECK(!bat_step_can_place(&odd));
    }
}

static void add_place(batten_model *model, const batten_model *definition, const char *name,
                      const batten_affine *place)
{
    CHECK_OK(batten_model_add(model, &(batten_object){.name = name,
                                                      .kind = BATTEN_OBJECT_INSTANCE,
                                                      .definition = definition,
                                                      .place = *place}));
}

/* z and x of the place are the third and the first column of the map. */
TEST(an_instance_has_its_place_its_number_and_its_name)
{
    const batten_affine quarter = {{{0, -1, 0}, {0, 0, -1}, {1, 0, 0}}, {5, -7, 11}},
                        identity = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
    batten_model *part = curve_model(1), *model = curve_model(1);
    add_place(model, part, "fore", &quarter);
    add_place(model, part, "aft", &identity);
    const char *text = step_text(model, NULL);
    step_check(text);
    step_check_references(text);
    CHECK_INT(step_count(text, "NEXT_ASSEMBLY_USAGE_OCCURRENCE"), 2);
    CHECK_CONTAINS(text, "NEXT_ASSEMBLY_USAGE_OCCURRENCE('1','fore','',#");
    CHECK_CONTAINS(text, "NEXT_ASSEMBLY_USAGE_OCCURRENCE('2','aft','',#");
    CHECK_INT(step_count(text, "ITEM_DEFINED_TRANSFORMATION"), 2);
    CHECK_INT(step_count(text, "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION"), 2);
    CHECK_INT(step_count(text, "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION"), 2);
    CHECK_INT(step_count(text, "PRODUCT"), 2);
    const char *at = strstr(text, "=CARTESIAN_POINT('',(5.,-7.,11.));\n");
    CHECK(at != NULL);
    CHECK_CONTAINS(at, "=DIRECTION('',(0.,-1.,0.));\n");
    const char *z = strstr(at, "=DIRECTION('',(0.,-1.,0.));\n"),
               *x = strstr(at, "=DIRECTION('',(0.,0.,1.));\n");
    CHECK(z != NULL && x != NULL && z < x && x < strstr(at, "AXIS2_PLACEMENT_3D("));
    batten_model_unref(part);
    batten_model_unref(model);
}

/* What the standard calls one thing has one id: numbers are added to names that repeat, and to none that is taken. */
TEST(products_of_one_name_have_ids_of_their_own)
{
    const batten_affine identity = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
    static const char *const names[] = {"rib", "rib.2", "rib", "rib", "plank", "plank", "", ""};
    static const char *const ids[] = {"'rib','rib'",   "'rib.2','rib.2'", "'rib.3','rib'",
                                      "'rib.4','rib'", "'plank','plank'", "'plank.2','plank'",
                                      "'hull','hull'"};
    batten_model *model = curve_model(1);
    for (int i = 0; i < COUNT(names); i++) {
        batten_model *part = curve_model(1);
        add_place(model, part, names[i], &identity);
        batten_model_unref(part);
    }
    const char *text = step_text(model, NULL);
    step_check(text);
    CHECK_INT(step_count(text, "PRODUCT"), 9);
    for (int i = 0; i < COUNT(ids); i++) {
        char row[100];
        snprintf(row, sizeof row, "PRODUCT(%s,", ids[i]);
        const char *at = strstr(text, row);
        CHECK(at != NULL);
        CHECK(strstr(at + 1, row) == NULL);
    }
    batten_model_unref(model);
}

TEST(a_schema_that_is_none_is_refused_and_a_mesh_needs_AP242)
{
    const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const int corners[] = {0, 1, 2};
    batten_write_options options = batten_write_defaults();
    batten_model *model = curve_model(1);
    batten_mesh *mesh = NULL;
    batten_notes *notes = NULL;
    char other[1] = {0}, *data = other;
    size_t size = 77;
    options.format = BATTEN_FORMAT_STEP;
    options.schema = (batten_step_schema)7;
    CHECK_STATUS(batten_write_memory(model, &options, NULL, &data, &size), BATTEN_BAD_ARGUMENT);
    CHECK_TEXT(batten_message(), "unknown STEP schema 7");
    CHECK(data == other && size == 77);
    CHECK_OK(batten_mesh_create(
        &(batten_mesh_parts){
            .vertex_count = 3, .points = points, .triangle_count = 1, .corners = corners},
        &mesh));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "tri", .kind = BATTEN_OBJECT_MESH, .mesh = mesh}));
    CHECK_OK(batten_notes_create(5, &notes));
    const char *text = step_text(model, notes);
    step_check(text);
    CHECK(strstr(text, "TRIANGULATED_FACE") == NULL && strstr(text, "TESSELLATED") == NULL);
    CHECK(batten_notes_dropped(notes) ||
          has_note(notes, "those of schema ap242 (--schema ap242) hold meshes"));
    batten_notes_free(notes);
    batten_mesh_unref(mesh);
    batten_model_unref(model);
}
