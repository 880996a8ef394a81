/* The feature 'select': some objects of a feature, by name. */
#include "base/plural.h"
#include "design/feature.h"

#include <string.h>

static const batten_parameter parameters[] = {
    {"select", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "from what"},
    {"names", BATTEN_VALUE_TEXT, true, true, NULL, NULL,
     "the names of the objects, in the order wanted"},
};

static batten_status select_object(bat_run *run, const batten_model *model, const char *name)
{
    const int at = batten_model_find(model, name);
    if (at < 0)
        return bat_fail(BATTEN_NOT_FOUND,
                        "'%s' has no object '%s'; its %d object%s begin%s with '%s'",
                        bat_text(run, "select"), name, batten_model_count(model),
                        bat_plural(batten_model_count(model)),
                        bat_one_or_many(batten_model_count(model), "s", ""),
                        batten_model_object(model, 0)->name);
    return bat_add(run, batten_model_object(model, at));
}

static batten_status run_select(bat_run *run)
{
    const batten_model *model = bat_model(run, "select");
    const bat_argument *names = bat_argument_of(run, "names");
    batten_status status = BATTEN_OK;
    for (int i = 0; i < names->count && status == BATTEN_OK; i++)
        status = select_object(run, model, names->items[i].text);
    return status;
}

const bat_feature bat_feature_select = {
    .shown = {"select", "Some objects of a feature, by name",
              "In the order in which the names are given.",
              "features:\n"
              "  ducks: {points: [[0, 0], [1, 0], [0, 1], [1, 1]], columns: 2}\n"
              "  upper: {select: ducks, names: row 2}\n",
              "", "batten_model_find", BAT_PARAMETERS(parameters), false,
              .also = "pick, filter by name, extract"},
    .run = run_select,
    .cuts = true};
