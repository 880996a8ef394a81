/* A check of a design whose features have results that the test makes: what it finds, field by field. */
#ifndef TESTS_DESIGN_OUTPUTS_CHECKED_H
#define TESTS_DESIGN_OUTPUTS_CHECKED_H
#include "design/outputs/fairness.h"
#include "support/test.h"

#include <math.h>
#include <string.h>

enum { CHECKED_FEATURES = 10 };

typedef struct {
    bat_document document;
    bat_result results[CHECKED_FEATURES];
    bat_run run;
    bat_check check;
} checked_design;

static inline batten_status checked_parse(const char *text, bat_document *out)
{
    const batten_design_options options = batten_design_defaults();
    const batten_status status =
        bat_document_parse(text, strlen(text), &options, &bat_all_features, NULL, out);
    if (status != BATTEN_OK)
        bat_document_free(out);
    return status;
}

/* Lines of features, and what is checked: "[a, b]". */
static inline void checked_open(const char *features, const char *what, checked_design *out)
{
    char text[1000];
    *out = (checked_design){.run = {.name = "r.txt"}};
    snprintf(text, sizeof text,
             "batten: 1\nunits: m\nfeatures:\n%soutputs:\n  r.txt: {check: %s}\n", features,
             what);
    CHECK_OK(checked_parse(text, &out->document));
    CHECK(out->document.feature_count <= CHECKED_FEATURES);
    for (int i = 0; i < out->document.feature_count; i++) {
        out->results[i].shown.name = out->document.features[i].name;
        CHECK_OK(batten_model_create(1, &out->results[i].value));
    }
    out->run.document = &out->document;
    out->run.results = out->results;
    out->run.feature = &out->document.outputs[0].feature->shown;
    out->run.arguments = out->document.outputs[0].arguments;
}

static inline bat_result *checked_result(checked_design *design, const char *feature)
{
    const int index = bat_document_feature(&design->document, feature);
    CHECK(index >= 0);
    return &design->results[index];
}

static inline void checked_put(checked_design *design, const char *feature,
                               const batten_object *object)
{
    CHECK_OK(batten_model_add(checked_result(design, feature)->value, object));
}

static inline void checked_put_surface(checked_design *design, const char *feature,
                                       batten_surface *surface)
{
    checked_put(
        design, feature,
        &(batten_object){.name = feature, .kind = BATTEN_OBJECT_SURFACE, .surface = surface});
    batten_surface_unref(surface);
}

/* Straight from a to b. */
static inline void checked_put_line(checked_design *design, const char *feature, batten_vec3 a,
                                    batten_vec3 b)
{
    batten_curve *line = NULL;
    CHECK_OK(batten_curve_line(3, &a.x, &b.x, &line));
    checked_put(design, feature,
                &(batten_object){.name = feature, .kind = BATTEN_OBJECT_CURVE, .curve = line});
    batten_curve_unref(line);
}

static inline void checked_put_points(checked_design *design, const char *feature, int count,
                                      const double *points)
{
    checked_put(design, feature,
                &(batten_object){.name = feature,
                                 .kind = BATTEN_OBJECT_POINTS,
                                 .point_count = count,
                                 .points = points});
}

static inline batten_status checked_try(checked_design *design, double within)
{
    const bat_fair_bounds bounds = {1e-6, 1e-6};
    bat_check_release(&design->check);
    return bat_check_all(&design->run, "check", within, &bounds, &bounds, &design->check);
}

/* What the check found of its object of this index, from 0. */
static inline const bat_checked *checked_run(checked_design *design, double within)
{
    CHECK_OK(checked_try(design, within));
    return design->check.objects;
}

static inline void checked_close(checked_design *design)
{
    bat_check_release(&design->check);
    for (int i = 0; i < design->document.feature_count; i++)
        batten_model_unref(design->results[i].value);
    bat_document_free(&design->document);
}

#endif
