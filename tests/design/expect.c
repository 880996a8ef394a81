/* Facts about the result of a feature: see expect.h. */
#include "design/expect.h"
#include "design/evaluate.h"
#include "design/facts.h"

#include <batten/triangles.h>
#include <stdlib.h>

const batten_object *fact_object(const subject *of, double index)
{
    CHECK(index >= 0 && index < batten_model_count(of->result->value));
    return batten_model_object(of->result->value, (int)index);
}

/* All that is wrong in a table is listed before the test fails. */
static int wrong;

void fact_near(const subject *of, const fact *f, double actual, double expected)
{
    if (fabs(actual - expected) <= of->within * (1 + fabs(expected)))
        return;
    wrong++;
    fprintf(stderr, "a: %s\n    %s %s: found %.16g, expected %.16g\n", of->feature, f->word,
            f->rest, actual, expected);
}

void fact_near_point(const subject *of, const fact *f, const double *actual,
                     const double *expected)
{
    for (int k = 0; k < 3; k++)
        fact_near(of, f, actual[k], expected[k]);
}

static void fact_false(const subject *of, const fact *f, const char *text)
{
    wrong++;
    fprintf(stderr, "a: %s\n    %s %s: found %s\n", of->feature, f->word, f->rest,
            text ? text : "nothing");
}

static void says(const subject *of, const fact *f, const char *text)
{
    if (!text || !strstr(text, f->rest))
        fact_false(of, f, text);
}

/* ---- facts ---- */

static void check_objects(subject *of, const fact *f)
{
    fact_near(of, f, batten_model_count(of->result->value), f->number[0]);
}

static void check_object(subject *of, const fact *f)
{
    of->object = fact_object(of, f->number[0]);
}

static void check_named(subject *of, const fact *f)
{
    says(of, f, of->object->name);
}

static void check_layer(subject *of, const fact *f)
{
    says(of, f, of->object->layer);
}

static void check_kind(subject *of, const fact *f)
{
    says(of, f, batten_object_kind_name(of->object->kind));
}

static void check_within(subject *of, const fact *f)
{
    of->within = f->number[0];
}

static void check_degree(subject *of, const fact *f)
{
    const batten_object *o = of->object;
    if (o->triangles)
        fact_near(of, f, batten_triangles_degree(o->triangles), f->number[0]);
    else
        fact_near(of, f,
                  o->curve ? batten_curve_degree(o->curve)
                           : batten_surface_degree(o->surface, BATTEN_U),
                  f->number[0]);
    if (f->count > 1)
        fact_near(of, f, batten_surface_degree(o->surface, BATTEN_V), f->number[1]);
}

static void check_count(subject *of, const fact *f)
{
    const batten_object *o = of->object;
    if (o->triangles)
        fact_near(of, f, batten_triangles_count(o->triangles), f->number[0]);
    else if (o->kind == BATTEN_OBJECT_POINTS)
        fact_near(of, f, o->point_count, f->number[0]);
    else
        fact_near(of, f,
                  o->curve ? batten_curve_point_count(o->curve)
                           : batten_surface_point_count(o->surface, BATTEN_U),
                  f->number[0]);
    if (f->count > 1)
        fact_near(of, f, batten_surface_point_count(o->surface, BATTEN_V), f->number[1]);
}

static void check_rational(subject *of, const fact *f)
{
    fact_near(of, f,
              of->object->curve ? batten_curve_is_rational(of->object->curve)
                                : batten_surface_is_rational(of->object->surface),
              f->number[0]);
}

static void check_closed(subject *of, const fact *f)
{
    fact_near(of, f, batten_curve_is_closed(of->object->curve, 1e-9), f->number[0]);
}

static void check_domain(subject *of, const fact *f)
{
    const batten_interval domain = batten_curve_domain(of->object->curve);
    fact_near(of, f, domain.a, f->number[0]);
    fact_near(of, f, domain.b, f->number[1]);
}

static void check_spans(subject *of, const fact *f)
{
    fact_near(of, f, of->object->chain ? batten_chain_span_count(of->object->chain) : 0,
              f->number[0]);
}

static void check_control(subject *of, const fact *f)
{
    const batten_object *o = of->object;
    const double *points =
        o->curve ? batten_curve_points(o->curve) : batten_surface_points(o->surface);
    fact_near_point(of, f, points + 3 * (int)f->number[0], f->number + 1);
}

static void check_data(subject *of, const fact *f)
{
    const int i = (int)f->number[0];
    CHECK(i < of->object->point_count);
    fact_near_point(of, f, of->object->points + 3 * (size_t)i, f->number + 1);
}

static void check_error(subject *of, const fact *f)
{
    CHECK(of->result->has_error);
    fact_near(of, f, fmax(of->result->error_max, f->number[0]), f->number[0]);
    CHECK(of->result->error_rms <= of->result->error_max);
}

static void check_exact(subject *of, const fact *f)
{
    fact_near(of, f, of->result->has_error, 0);
}

static void check_moves(subject *of, const fact *f)
{
    fact_near(of, f, of->result->has_moves, 1);
    fact_near(of, f, of->result->moved_count, f->number[0]);
    fact_near(of, f, fmax(of->result->move_max, f->number[1]), f->number[1]);
}

static void check_notes(subject *of, const fact *f)
{
    if (batten_notes_dropped(of->notes)) /* as memory was missing for one */
        return;
    char all[3000] = "";
    for (int i = 0; i < batten_notes_count(of->notes); i++) {
        const size_t length = strlen(all);
        snprintf(all + length, sizeof all - length, "%s\n",
                 batten_notes_at(of->notes, i)->text);
    }
    says(of, f, all);
}

static void check_lacks(subject *of, const fact *f)
{
    for (int i = 0; i < batten_notes_count(of->notes); i++)
        if (strstr(batten_notes_at(of->notes, i)->text, f->rest))
            fact_false(of, f, batten_notes_at(of->notes, i)->text);
}

static void check_colour(subject *of, const fact *f)
{
    fact_near(of, f, of->object->has_colour, 1);
    fact_near_point(of, f, of->object->colour, f->number);
}

static void check_plain(subject *of, const fact *f)
{
    fact_near(of, f, of->object->has_colour, 0);
}

static void check_silent(subject *of, const fact *f)
{
    fact_near(of, f, batten_notes_count(of->notes), 0);
}

static const known_fact own_facts[] = {
    {"objects", check_objects}, {"object", check_object}, {"named", check_named},
    {"layer", check_layer},     {"kind", check_kind},     {"within", check_within},
    {"degree", check_degree},   {"count", check_count},   {"rational", check_rational},
    {"closed", check_closed},   {"domain", check_domain}, {"control", check_control},
    {"data", check_data},       {"error", check_error},   {"exact", check_exact},
    {"notes", check_notes},     {"silent", check_silent}, {"moves", check_moves},
    {"spans", check_spans},     {"lacks", check_lacks},   {"colour", check_colour},
    {"plain", check_plain},
};

static bool check_in(const known_fact *table, int count, subject *of, const fact *f)
{
    for (int i = 0; i < count; i++)
        if (strcmp(table[i].word, f->word) == 0) {
            table[i].check(of, f);
            return true;
        }
    return false;
}

static void check_fact(subject *of, char *text)
{
    fact f = {.number = {0}};
    int length = 0;
    CHECK(sscanf(text, " %23s%n", f.word, &length) == 1);
    f.rest = text + length + (text[length] == ' ');
    char *end = text + length;
    for (const char *from = end; f.count < FACT_NUMBERS; f.count++, from = end) {
        f.number[f.count] = strtod(from, &end);
        if (end == from)
            break;
    }
    if (check_in(own_facts, COUNT(own_facts), of, &f) ||
        check_in(geometry_facts, geometry_fact_count, of, &f))
        return;
    test_text(f.word, "a fact of expect.h", text, __FILE__, __LINE__);
}

static void check_result(const expect_row *row, const batten_design *design,
                         const batten_notes *notes)
{
    subject of = {row->feature, batten_design_result(design, "a"), NULL, notes, 1e-9};
    CHECK(of.result && of.result->value);
    if (batten_model_count(of.result->value) > 0)
        of.object = fact_object(&of, 0);
    char *text = test_array(strlen(row->facts) + 1, 1);
    strcpy(text, row->facts);
    for (char *part = strtok(text, ";"); part; part = strtok(NULL, ";"))
        check_fact(&of, part);
}

static void check_row(const char *before, const expect_row *row)
{
    char text[6000];
    batten_design *design = NULL;
    batten_notes *notes = NULL;
    snprintf(text, sizeof text, "batten: 1\nunits: m\ntolerance: 0.001\nfeatures:\n%s  a: %s\n",
             before, row->feature);
    CHECK_OK(batten_notes_create(30, &notes));
    batten_status status = evaluate_design(text, "a", notes, &design);
    if (test_memory_failed(status, row->status)) {
        batten_notes_free(notes); /* those of the first attempt */
        CHECK_OK(batten_notes_create(30, &notes));
        status = evaluate_design(text, "a", notes, &design);
    }
    if (status == BATTEN_OK && row->status == BATTEN_OK)
        check_result(row, design, notes);
    else if (status != row->status || !strstr(batten_message(), row->facts)) {
        wrong++;
        fprintf(stderr, "a: %s\n    %s, %s\n    expected %s, %s\n", row->feature,
                batten_status_name(status), batten_message(), batten_status_name(row->status),
                row->facts);
    }
    batten_design_free(design);
    batten_notes_free(notes);
}

void expect_rows(const char *before, const expect_row *rows, int count)
{
    wrong = 0;
    for (int i = 0; i < count; i++)
        check_row(before, &rows[i]);
    CHECK_INT(wrong, 0);
}

void expect_each(const char *before, const char *const *names, int name_count,
                 const expect_row *rows, int row_count)
{
    for (int i = 0; i < name_count; i++)
        for (int k = 0; k < row_count; k++) {
            char feature[300];
            const char *at = strchr(rows[k].feature, '@');
            CHECK(at != NULL);
            snprintf(feature, sizeof feature, "%.*s%s%s", (int)(at - rows[k].feature),
                     rows[k].feature, names[i], at + 1);
            expect_rows(before, &(expect_row){feature, rows[k].status, rows[k].facts}, 1);
        }
}
