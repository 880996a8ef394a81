#include "exchange/step/references.h"
#include "support/bodies.h"

static batten_model *marked_model(void)
{
    const double points[] = {1, 2, 3, 4, 5, 6};
    const double black[] = {0, 0, 0};
    test_random random = test_random_begin("marked_model");
    batten_curve *curve = random_curve(&random);
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    batten_object object = {.name = "keel",
                            .layer = "lines",
                            .group = "hull/port",
                            .is_hidden = true,
                            .kind = BATTEN_OBJECT_CURVE,
                            .curve = curve};
    CHECK_OK(batten_model_add(model, &object));
    object.name = "stem";
    object.layer = "it's";
    object.group = "hull";
    object.is_hidden = false;
    object.has_colour = true;
    CHECK_OK(batten_model_add(model, &object));
    object.name = "chine";
    object.layer = "lines";
    object.group = "hull/port";
    CHECK_OK(batten_model_add(model, &object));
    batten_object data = {.name = "data",
                          .has_colour = true,
                          .group = "x",
                          .kind = BATTEN_OBJECT_POINTS,
                          .point_count = 2,
                          .points = points};
    memcpy(data.colour, black, sizeof black);
    CHECK_OK(batten_model_add(model, &data));
    batten_curve_unref(curve);
    return model;
}

TEST(layers_groups_and_what_is_hidden_are_written)
{
    batten_model *model = marked_model();
    const char *text = step_text(model, NULL);
    step_check(text);
    CHECK_INT(step_count(text, "PRESENTATION_LAYER_ASSIGNMENT"), 2);
    CHECK_CONTAINS(text, "PRESENTATION_LAYER_ASSIGNMENT('it''s','',(#");
    CHECK_CONTAINS(text, "PRESENTATION_LAYER_ASSIGNMENT('lines','',(#");
    CHECK_INT(step_count(text, "INVISIBILITY"), 1);
    CHECK_INT(step_count(text, "STYLED_ITEM"), 4);
    CHECK_CONTAINS(text, "(NULL_STYLE(.NULL.))");
    CHECK_INT(step_count(text, "CURVE_STYLE"), 1); /* two curves look alike */
    CHECK_INT(step_count(text, "POINT_STYLE"), 1);
    CHECK_INT(step_count(text, "GROUP"), 3);
    CHECK_INT(step_count(text, "GROUP_RELATIONSHIP"), 1);
    CHECK_INT(step_count(text, "APPLIED_GROUP_ASSIGNMENT"), 3);
    CHECK_CONTAINS(text, "=GROUP('hull','');\n");
    CHECK_CONTAINS(text, "=GROUP('port','');\n");
    batten_model_unref(model);
}

TEST(groups_of_odd_names_end)
{
    static const char *const names[] = {"/", "//", "a//b", "a/", "/a", "a", "a-b", "a/b/c/d"};
    const double points[] = {1, 2, 3};
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    for (int i = 0; i < COUNT(names); i++)
        CHECK_OK(batten_model_add(model, &(batten_object){.name = "p",
                                                          .group = names[i],
                                                          .kind = BATTEN_OBJECT_POINTS,
                                                          .point_count = 1,
                                                          .points = points}));
    const char *text = step_text(model, NULL);
    step_check(text);
    CHECK_INT(step_count(text, "APPLIED_GROUP_ASSIGNMENT"), COUNT(names));
    batten_model_unref(model);
}

static char *text_in(const batten_model *model, batten_step_schema schema, batten_notes *notes)
{
    batten_write_options options = batten_write_defaults();
    char *data = NULL;
    size_t size = 0;
    options.format = BATTEN_FORMAT_STEP;
    options.schema = schema;
    options.date = "2026-11-21T10:25:30";
    CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
    step_check(data);
    step_check_references(data);
    return data;
}

TEST(AP203_has_who_and_when_and_no_colours)
{
    batten_model *model = marked_model();
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(5, &notes));
    char *text = text_in(model, BATTEN_STEP_AP203, notes);
    CHECK_CONTAINS(text, "FILE_SCHEMA(('CONFIG_CONTROL_DESIGN'));");
    CHECK_CONTAINS(text, "=CALENDAR_DATE(2026,21,11);\n");
    CHECK_CONTAINS(text, "=LOCAL_TIME(10,25,30.,#");
    CHECK_INT(step_count(text, "CC_DESIGN_APPROVAL"), 1);
    CHECK_INT(step_count(text, "CC_DESIGN_PERSON_AND_ORGANIZATION_ASSIGNMENT"), 4);
    CHECK_INT(step_count(text, "STYLED_ITEM"), 0);
    CHECK_INT(step_count(text, "INVISIBILITY"), 0);
    CHECK_INT(step_count(text, "GROUP"), 0);
    CHECK(batten_notes_dropped(notes) || has_note(notes, "AP203 has no colours"));
    batten_notes_free(notes);
    batten_release(text);
    batten_model_unref(model);
}

static batten_status count_remarks(const batten_model *model, batten_step_schema schema,
                                   int *count)
{
    batten_write_options options = batten_write_defaults();
    batten_notes *notes = NULL;
    char *data = NULL;
    size_t size = 0;
    options.format = BATTEN_FORMAT_STEP;
    options.schema = schema;
    batten_status status = batten_notes_create(5, &notes);
    if (status == BATTEN_OK)
        status = batten_write_memory(model, &options, notes, &data, &size);
    *count = status == BATTEN_OK ? batten_notes_count(notes) + batten_notes_dropped(notes) : -1;
    batten_release(data);
    batten_notes_free(notes);
    return status;
}

TEST(colours_that_are_left_out_are_remarked_upon_once)
{
    static const batten_step_schema schemas[] = {BATTEN_STEP_AP203, BATTEN_STEP_AP214,
                                                 BATTEN_STEP_AP242};
    batten_model *model = marked_model();
    for (int i = 0; i < COUNT(schemas); i++) {
        int count = 0;
        CHECK_OK(count_remarks(model, schemas[i], &count));
        CHECK_INT(count, schemas[i] == BATTEN_STEP_AP203);
    }
    batten_model_unref(model);
}

/* Who did what and when, of one product: ISO 10303-203. */
TEST(AP203_assigns_each_duty_date_and_approval)
{
    static const struct {
        const char *keyword;
        int count;
    } rows[] = {{"PRODUCT", 1},
                {"PRODUCT_RELATED_PRODUCT_CATEGORY", 1},
                {"PRODUCT_CATEGORY", 1},
                {"PRODUCT_CATEGORY_RELATIONSHIP", 1},
                {"PERSON_AND_ORGANIZATION", 1},
                {"CC_DESIGN_SECURITY_CLASSIFICATION", 1},
                {"CC_DESIGN_DATE_AND_TIME_ASSIGNMENT", 2},
                {"DATE_TIME_ROLE", 2},
                {"PERSON_AND_ORGANIZATION_ROLE", 4},
                {"APPROVAL", 1},
                {"APPROVAL_ROLE", 1},
                {"APPROVAL_PERSON_ORGANIZATION", 1},
                {"APPROVAL_DATE_TIME", 1},
                {"CC_DESIGN_APPROVAL", 1}};
    static const struct {
        const char *keyword, *role;
        int references;
    } duties[] = {{"PERSON_AND_ORGANIZATION_ROLE", "'creator'", 4},
                  {"PERSON_AND_ORGANIZATION_ROLE", "'design_supplier'", 3},
                  {"PERSON_AND_ORGANIZATION_ROLE", "'design_owner'", 3},
                  {"PERSON_AND_ORGANIZATION_ROLE", "'classification_officer'", 3},
                  {"DATE_TIME_ROLE", "'creation_date'", 3},
                  {"DATE_TIME_ROLE", "'classification_date'", 3}};
    batten_model *model = marked_model();
    char *text = text_in(model, BATTEN_STEP_AP203, NULL);
    for (int i = 0; i < COUNT(rows); i++)
        CHECK_INT(step_count(text, rows[i].keyword), rows[i].count);
    for (int i = 0; i < COUNT(duties); i++) {
        char role[100];
        int ids[9];
        snprintf(role, sizeof role, "=%s(%s);", duties[i].keyword, duties[i].role);
        const char *at = strstr(text, role);
        CHECK(at != NULL); /* the assignment follows its role */
        at = strstr(at, "=CC_DESIGN_");
        CHECK_INT(step_ids(at + 1, COUNT(ids), ids), duties[i].references);
    }
    CHECK_INT(step_ids(strstr(text, "=CC_DESIGN_APPROVAL(") + 1, 9, (int[9]){0}), 4);
    batten_release(text);
    batten_model_unref(model);
}

TEST(meshes_go_with_AP242_only)
{
    const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const int corners[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    const batten_mesh_parts parts = {
        .vertex_count = 4, .points = points, .triangle_count = 4, .corners = corners};
    batten_mesh *mesh = NULL;
    batten_notes *notes = NULL;
    batten_model *model = marked_model();
    CHECK_OK(batten_notes_create(5, &notes));
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "tet", .kind = BATTEN_OBJECT_MESH, .mesh = mesh}));
    char *text = text_in(model, BATTEN_STEP_AP242, notes);
    CHECK_CONTAINS(text, "=COORDINATES_LIST('',4,((0.,0.,0.),(1.,0.,0.),(0.,1.,0.),");
    CHECK_CONTAINS(text, "=TRIANGULATED_FACE('tet',#");
    CHECK_CONTAINS(text, ",4,(),$,(),((1,3,2),(1,2,4),(1,4,3),(2,3,4)));\n");
    CHECK_INT(step_count(text, "TESSELLATED_SHAPE_REPRESENTATION"), 1);
    batten_release(text);
    text = text_in(model, BATTEN_STEP_AP214, notes);
    CHECK_INT(step_count(text, "TRIANGULATED_FACE"), 0);
    CHECK(batten_notes_dropped(notes) || has_note(notes, "left out: STEP files hold points"));
    batten_release(text);
    batten_notes_free(notes);
    batten_mesh_unref(mesh);
    batten_model_unref(model);
}

/* The date of the file where it has the form of the standard; else a neutral one, never a part of it. */
TEST(dates_of_AP203_are_whole_or_neutral)
{
    static const struct {
        const char *date, *day, *time;
    } rows[] = {
        {"2026-11-21T10:25:30", "CALENDAR_DATE(2026,21,11)", "LOCAL_TIME(10,25,30.,#"},
        {"1987-06-05T04:03:02", "CALENDAR_DATE(1987,5,6)", "LOCAL_TIME(4,3,2.,#"},
        {NULL, "CALENDAR_DATE(2000,1,1)", "LOCAL_TIME(0,0,0.,#"},
        {"2026-11-21 10:25:30", "CALENDAR_DATE(2000,1,1)", "LOCAL_TIME(0,0,0.,#"},
        {"2026-11-21T10:25:3", "CALENDAR_DATE(2000,1,1)", "LOCAL_TIME(0,0,0.,#"},
        {"2026-1:-21T10:25:30", "CALENDAR_DATE(2000,1,1)", "LOCAL_TIME(0,0,0.,#"},
        {"2026-1/-21T10:25:30", "CALENDAR_DATE(2000,1,1)", "LOCAL_TIME(0,0,0.,#"},
        {"", "CALENDAR_DATE(2000,1,1)", "LOCAL_TIME(0,0,0.,#"},
    };
    batten_model *model = marked_model();
    for (int i = 0; i < COUNT(rows); i++) {
        batten_write_options options = batten_write_defaults();
        char *data = NULL;
        size_t size = 0;
        options.format = BATTEN_FORMAT_STEP;
        options.schema = BATTEN_STEP_AP203;
        options.date = rows[i].date;
        CHECK_OK(batten_write_memory(model, &options, NULL, &data, &size));
        step_check(data);
        CHECK_CONTAINS(data, rows[i].day);
        CHECK_CONTAINS(data, rows[i].time);
        batten_release(data);
    }
    batten_model_unref(model);
}

/* More colours than are remembered, twice: each is written, and those that repeat at once only once. */
TEST(colours_that_repeat_are_written_once_while_they_are_remembered)
{
    enum { COLOURS = 40 };
    const double point[] = {1, 2, 3};
    for (int twice = 1; twice <= 2; twice++) {
        batten_model *model = NULL;
        CHECK_OK(batten_model_create(1, &model));
        for (int i = 0; i < COLOURS * twice; i++) {
            batten_object data = {.name = "p",
                                  .has_colour = true,
                                  .kind = BATTEN_OBJECT_POINTS,
                                  .point_count = 1,
                                  .points = point};
            data.colour[0] = i / twice / 64.;
            data.colour[1] = 0.25;
            data.colour[2] = 1;
            CHECK_OK(batten_model_add(model, &data));
        }
        const char *text = step_text(model, NULL);
        step_check(text);
        CHECK_INT(step_count(text, "POINT_STYLE"), COLOURS);
        CHECK_INT(step_count(text, "STYLED_ITEM"), COLOURS * twice);
        CHECK_INT(step_count(text, "COLOUR_RGB"), COLOURS);
        CHECK_CONTAINS(text, "COLOUR_RGB('',0.609375,0.25,1.)");
        batten_model_unref(model);
    }
}

/* Names and years of the protocols, as their parts of ISO 10303 have them. */
TEST(each_schema_has_its_protocol_and_its_contexts)
{
    static const struct {
        batten_step_schema schema;
        const char *protocol, *application, *product, *definition;
    } rows[] = {
        {BATTEN_STEP_AP214, "'international standard','automotive_design',2000,#",
         "=APPLICATION_CONTEXT('core data for automotive mechanical design processes');",
         "=PRODUCT_CONTEXT('',#1,'mechanical');",
         "=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');"},
        {BATTEN_STEP_AP203, "'international standard','config_control_design',1994,#",
         "=APPLICATION_CONTEXT('configuration controlled 3d designs of mechanical parts and "
         "assemblies');",
         "=MECHANICAL_CONTEXT('',#1,'mechanical');", "=DESIGN_CONTEXT('',#1,'design');"},
        {BATTEN_STEP_AP242,
         "'international standard','ap242_managed_model_based_3d_engineering',2014,#",
         "=APPLICATION_CONTEXT('managed model based 3d engineering');",
         "=PRODUCT_CONTEXT('',#1,'mechanical');",
         "=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');"},
    };
    batten_model *model = marked_model();
    for (int i = 0; i < COUNT(rows); i++) {
        char *text = text_in(model, rows[i].schema, NULL);
        CHECK_CONTAINS(text, rows[i].protocol);
        CHECK_CONTAINS(text, rows[i].application);
        CHECK_CONTAINS(text, rows[i].product);
        CHECK_CONTAINS(text, rows[i].definition);
        batten_release(text);
    }
    batten_model_unref(model);
}

/* A set of points refers to them in their order. */
TEST(points_of_a_set_are_referred_to_one_by_one)
{
    const double points[] = {1, 2, 3, 4, 5, 6, 7, 8, 9};
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "data",
                                                      .kind = BATTEN_OBJECT_POINTS,
                                                      .point_count = 3,
                                                      .points = points}));
    const char *text = step_text(model, NULL);
    const char *at = strstr(text, "=CARTESIAN_POINT('',(1.,2.,3.));");
    CHECK(at != NULL);
    while (*at != '#')
        at--;
    const int first = atoi(at + 1);
    char words[100];
    snprintf(words, sizeof words, "GEOMETRIC_CURVE_SET('data',(#%d,#%d,#%d));", first,
             first + 1, first + 2);
    CHECK_CONTAINS(text, words);
    snprintf(words, sizeof words, "#%d=CARTESIAN_POINT('',(7.,8.,9.));", first + 2);
    CHECK_CONTAINS(text, words);
    batten_model_unref(model);
}
