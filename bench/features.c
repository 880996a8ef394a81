/*
 * What a feature costs: `batten-bench-features DESIGN` makes the last feature of a design, or its
 * last output where it has outputs, inside of `bench_measured`, after all that it needs. bench/features
 * runs it with many designs, and compares with the C function behind the feature.
 */
#include <batten/design.h>

#include <stdio.h>
#include <stdlib.h>

static void must(batten_status status)
{
    if (status == BATTEN_OK)
        return;
    fprintf(stderr, "bench: %s\n", batten_message());
    exit(1);
}

/* Not static, and called by a pointer: callgrind finds it by its name. */
void bench_measured(batten_design *design, const char *feature);

void bench_measured(batten_design *design, const char *feature)
{
    char *data = NULL;
    size_t size = 0;
    if (feature)
        must(batten_design_evaluate(design, feature, NULL, NULL));
    else
        must(batten_design_output(design, batten_design_output_count(design) - 1, NULL, NULL,
                                  &data, &size));
    batten_release(data);
}

int main(int count, char **arguments)
{
    /* The feature that is measured bears this name, and what it needs is made by the one before. */
    static const char needed[] = "needed", measured[] = "measured";
    void (*volatile measure)(batten_design *, const char *) = bench_measured;
    batten_design *design = NULL;
    if (count != 2) {
        fputs("usage: batten-bench-features DESIGN\n", stderr);
        return 2;
    }
    must(batten_design_open(arguments[1], false, NULL, &design));
    const bool has_output = batten_design_output_count(design) > 0;
    if (batten_design_evaluate(design, needed, NULL, NULL) != BATTEN_NOT_FOUND)
        must(batten_design_evaluate(design, needed, NULL, NULL));
    measure(design, has_output ? NULL : measured);
    batten_design_free(design);
    return 0;
}
