/* Contexts, units and products. */
#include "exchange/step/write/writing.h"

#include <batten/text.h>

/* ---- units ---- */

/* A length: a prefix of the metre, or so many of a metre under a name. */
static int put_length(bat_step *step, double metres)
{
    static const struct {
        double metres;
        const char *prefix;
        /* The prefixes of ISO 10303-41, as factors. */
    } prefixes[] = {
        {1, "$"}, {0.001, ".MILLI."}, {0.01, ".CENTI."}, {1000, ".KILO."}, {1e-6, ".MICRO."}};
    for (size_t k = 0; k < sizeof prefixes / sizeof prefixes[0]; k++)
        if (metres == prefixes[k].metres)
            return bat_step_add(step, "", "LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(%s,.METRE.)",
                                prefixes[k].prefix);
    const char *name = batten_unit_name(metres);
    const int metre = bat_step_add(step, "", "LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT($,.METRE.)");
    const int exponents = bat_step_add(step, "DIMENSIONAL_EXPONENTS", "1.,0.,0.,0.,0.,0.,0.");
    const int measure = bat_step_open(step, "LENGTH_MEASURE_WITH_UNIT");
    bat_step_token(step, "LENGTH_MEASURE(");
    bat_step_real(step, metres, "),");
    bat_step_id(step, metre, "");
    bat_step_close(step);
    const int id = bat_step_open(step, "");
    bat_step_token(step, "CONVERSION_BASED_UNIT(");
    bat_step_string(step,
                    metres == 0.0254   ? "INCH"
                    : metres == 0.3048 ? "FOOT"
                    : name             ? name
                                       : "UNIT",
                    ",");
    bat_step_id(step, measure, ") ");
    bat_step_token(step, "LENGTH_UNIT() NAMED_UNIT(");
    bat_step_id(step, exponents, ")");
    bat_step_close(step);
    return id;
}

static void put_units(bat_step_writing *w, double unit_metres)
{
    bat_step *step = &w->step;
    const int length = put_length(step, unit_metres);
    const int angle =
        bat_step_add(step, "", "NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.)");
    const int solid =
        bat_step_add(step, "", "NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT()");
    const int accuracy = bat_step_open(step, "UNCERTAINTY_MEASURE_WITH_UNIT");
    bat_step_token(step, "LENGTH_MEASURE(");
    bat_step_real(step, step->tolerance, "),");
    bat_step_id(step, length, ",");
    bat_step_token(step, "'distance_accuracy_value',''");
    bat_step_close(step);
    w->context = bat_step_open(step, "");
    bat_step_token(step,
                   "GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((");
    bat_step_id(step, accuracy, ")) ");
    bat_step_token(step, "GLOBAL_UNIT_ASSIGNED_CONTEXT((");
    bat_step_id(step, length, ",");
    bat_step_id(step, angle, ",");
    bat_step_id(step, solid, ")) ");
    bat_step_token(step, "REPRESENTATION_CONTEXT('','3D')");
    bat_step_close(step);
}

void bat_step_put_contexts(bat_step_writing *w, double unit_metres)
{
    static const struct {
        const char *application, *protocol;
        int year;
        const char *product, *definition, *definition_name;
    } schemas[] = {
        [BATTEN_STEP_AP214] = {"core data for automotive mechanical design processes",
                               "automotive_design", 2000, "PRODUCT_CONTEXT",
                               "PRODUCT_DEFINITION_CONTEXT", "part definition"},
        [BATTEN_STEP_AP203] = {"configuration controlled 3d designs of mechanical parts and "
                               "assemblies",
                               "config_control_design", 1994, "MECHANICAL_CONTEXT",
                               "DESIGN_CONTEXT", ""},
        [BATTEN_STEP_AP242] = {"managed model based 3d engineering",
                               "ap242_managed_model_based_3d_engineering", 2014,
                               "PRODUCT_CONTEXT", "PRODUCT_DEFINITION_CONTEXT",
                               "part definition"},
    };
    bat_step *step = &w->step;
    const batten_step_schema schema = w->options->schema;
    w->application =
        bat_step_add(step, "APPLICATION_CONTEXT", "'%s'", schemas[schema].application);
    bat_step_add(step, "APPLICATION_PROTOCOL_DEFINITION",
                 "'international standard','%s',%d,#%d", schemas[schema].protocol,
                 schemas[schema].year, w->application);
    w->product_context =
        bat_step_add(step, schemas[schema].product, "'',#%d,'mechanical'", w->application);
    w->definition_context = bat_step_add(step, schemas[schema].definition, "'%s',#%d,'design'",
                                         schemas[schema].definition_name, w->application);
    put_units(w, unit_metres);
}

/* ---- products ---- */

batten_status bat_step_put_product(bat_step_writing *w, const char *id, const char *name,
                                   int *definition)
{
    bat_step *step = &w->step;
    const bool design = w->options->schema == BATTEN_STEP_AP203;
    const int product = bat_step_open(step, "PRODUCT");
    bat_step_string(step, id, ",");
    bat_step_string(step, name, ",'',(");
    bat_step_id(step, w->product_context, ")");
    bat_step_close(step);
    if (!design)
        bat_step_add(step, "PRODUCT_RELATED_PRODUCT_CATEGORY", "'part',$,(#%d)", product);
    const int formation =
        design ? bat_step_add(step, "PRODUCT_DEFINITION_FORMATION_WITH_SPECIFIED_SOURCE",
                              "'','',#%d,.MADE.", product)
               : bat_step_add(step, "PRODUCT_DEFINITION_FORMATION", "'','',#%d", product);
    *definition = bat_step_add(step, "PRODUCT_DEFINITION", "'design','',#%d,#%d", formation,
                               w->definition_context);
    batten_status status = BATTEN_OK;
    if (design) {
        status = bat_step_bag_add(&w->products, product);
        if (status == BATTEN_OK)
            status = bat_step_bag_add(&w->formations, formation);
        if (status == BATTEN_OK)
            status = bat_step_bag_add(&w->definitions, *definition);
    }
    return status;
}

/* ---- what AP203 wants to know ---- */

/* KEYWORD(#first,#second,(items of both bags, and one more)); 0 is none. */
static void assign(bat_step *step, const char *keyword, const int head[2],
                   const bat_step_bag *a, const bat_step_bag *b, int more)
{
    bat_step_open(step, keyword);
    for (int k = 0; k < 2 && head[k]; k++)
        bat_step_id(step, head[k], ",");
    bat_step_token(step, "(");
    bat_step_ids(step, a->ids, a->count, b->count || more ? "," : ")");
    bat_step_ids(step, b->ids, b->count, more ? "," : ")");
    if (more)
        bat_step_id(step, more, ")");
    bat_step_close(step);
}

/* The number that stands at `from` in the date "2026-11-21T10:25:00". */
static int part_of_date(const char *date, int from, int length)
{
    int value = 0;
    for (int i = from; i < from + length; i++)
        value = 10 * value + (date[i] - '0');
    return value;
}

static int put_date(bat_step_writing *w)
{
    static const char shape[] = "dddd-dd-ddTdd:dd:dd";
    bat_step *step = &w->step;
    const char *date = w->options->date;
    for (int i = 0; date && shape[i]; i++)
        if (shape[i] == 'd' ? date[i] < '0' || date[i] > '9' : date[i] != shape[i])
            date = NULL;
    if (!date)
        date = BAT_STEP_NEUTRAL_DATE;
    const int day = bat_step_add(step, "CALENDAR_DATE", "%d,%d,%d", part_of_date(date, 0, 4),
                                 part_of_date(date, 8, 2), part_of_date(date, 5, 2));
    const int zone = bat_step_add(step, "COORDINATED_UNIVERSAL_TIME_OFFSET", "0,0,.AHEAD.");
    const int time =
        bat_step_add(step, "LOCAL_TIME", "%d,%d,%d.,#%d", part_of_date(date, 11, 2),
                     part_of_date(date, 14, 2), part_of_date(date, 17, 2), zone);
    return bat_step_add(step, "DATE_AND_TIME", "#%d,#%d", day, time);
}

static void put_persons(bat_step_writing *w, int person, int classification)
{
    bat_step *step = &w->step;
    const bat_step_bag none = {0};
    const struct {
        const char *role;
        const bat_step_bag *first, *second;
        int more;
    } duties[] = {{"creator", &w->formations, &w->definitions, 0},
                  {"design_supplier", &w->formations, &none, 0},
                  {"design_owner", &w->products, &none, 0},
                  {"classification_officer", &none, &none, classification}};
    for (size_t k = 0; k < sizeof duties / sizeof duties[0]; k++) {
        const int role =
            bat_step_add(step, "PERSON_AND_ORGANIZATION_ROLE", "'%s'", duties[k].role);
        assign(step, "CC_DESIGN_PERSON_AND_ORGANIZATION_ASSIGNMENT", (int[]){person, role},
               duties[k].first, duties[k].second, duties[k].more);
    }
}

static void put_dates(bat_step_writing *w, int date, int classification)
{
    bat_step *step = &w->step;
    const bat_step_bag none = {0};
    const int created = bat_step_add(step, "DATE_TIME_ROLE", "'creation_date'");
    assign(step, "CC_DESIGN_DATE_AND_TIME_ASSIGNMENT", (int[]){date, created}, &w->definitions,
           &none, 0);
    const int classified = bat_step_add(step, "DATE_TIME_ROLE", "'classification_date'");
    assign(step, "CC_DESIGN_DATE_AND_TIME_ASSIGNMENT", (int[]){date, classified}, &none, &none,
           classification);
}

void bat_step_put_management(bat_step_writing *w)
{
    bat_step *step = &w->step;
    const bat_step_bag none = {0};
    const int detail = bat_step_open(step, "PRODUCT_RELATED_PRODUCT_CATEGORY");
    bat_step_token(step, "'detail','',(");
    bat_step_ids(step, w->products.ids, w->products.count, ")");
    bat_step_close(step);
    const int part = bat_step_add(step, "PRODUCT_CATEGORY", "'part',''");
    bat_step_add(step, "PRODUCT_CATEGORY_RELATIONSHIP", "'','',#%d,#%d", part, detail);

    const int who = bat_step_add(step, "PERSON", "'','',$,$,$,$");
    const int where = bat_step_add(step, "ORGANIZATION", "'','',''");
    const int person = bat_step_add(step, "PERSON_AND_ORGANIZATION", "#%d,#%d", who, where);
    const int date = put_date(w);
    const int level = bat_step_add(step, "SECURITY_CLASSIFICATION_LEVEL", "'unclassified'");
    const int classification =
        bat_step_add(step, "SECURITY_CLASSIFICATION", "'','',#%d", level);
    assign(step, "CC_DESIGN_SECURITY_CLASSIFICATION", (int[]){classification, 0},
           &w->formations, &none, 0);
    put_persons(w, person, classification);
    put_dates(w, date, classification);

    const int state = bat_step_add(step, "APPROVAL_STATUS", "'not_yet_approved'");
    const int approval = bat_step_add(step, "APPROVAL", "#%d,''", state);
    const int approver = bat_step_add(step, "APPROVAL_ROLE", "'approver'");
    bat_step_add(step, "APPROVAL_PERSON_ORGANIZATION", "#%d,#%d,#%d", person, approval,
                 approver);
    bat_step_add(step, "APPROVAL_DATE_TIME", "#%d,#%d", date, approval);
    assign(step, "CC_DESIGN_APPROVAL", (int[]){approval, 0}, &w->formations, &w->definitions,
           classification);
}
