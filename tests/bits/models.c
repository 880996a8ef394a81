/*
 * One line for the example of each feature: its name, how it ended, and a checksum of what it made as the bytes of files in
 * every format, and of its reports. Builds that keep the promise of the same bits print the same lines.
 * Usage: batten-bits FOLDER    (the examples' files are written there)
 */
#include <batten/batten.h>
#include <batten/design.h>
#include <batten/text.h>

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* Fowler, Noll and Vo's checksum of 64 bits. */
static const uint64_t start_of_sum = 0xcbf29ce484222325, factor_of_sum = 0x100000001b3;

static uint64_t add_bytes(uint64_t sum, const char *data, size_t size)
{
    for (size_t i = 0; i < size; i++)
        sum = (sum ^ (unsigned char)data[i]) * factor_of_sum;
    return sum;
}

/* A small hull for the examples that read offsets.csv: half-breadths of a parabolic boat. */
static void write_offsets(const char *folder)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/offsets.csv", folder);
    FILE *file = fopen(path, "w");
    if (!file)
        return;
    fputs("x_m,z_m,half_breadth_m\n", file);
    for (int i = 0; i <= 6; i++)
        for (int k = 0; k <= 5; k++) {
            const double x = i - 3.0, z = 0.2 * k;
            fprintf(file, "%.3f,%.3f,%.6f\n", x, z, (1.2 - x * x / 12) * sqrt(z + 0.04));
        }
    fclose(file);
}

/* A model in every format that can hold some of it. */
static uint64_t add_model(uint64_t sum, const batten_model *model)
{
    for (batten_format format = BATTEN_FORMAT_OFFSET_TABLE; format <= BATTEN_FORMAT_3MF;
         format++) {
        batten_write_options options = batten_write_defaults();
        options.format = format;
        char *data = NULL;
        size_t size = 0;
        const batten_status status = batten_write_memory(model, &options, NULL, &data, &size);
        const char *name = batten_status_name(status);
        sum = status == BATTEN_OK ? add_bytes(sum, data, size)
                                  : add_bytes(sum, name, strlen(name));
        batten_release(data);
    }
    return sum;
}

static uint64_t add_results(uint64_t sum, batten_design *design)
{
    for (int i = 0; i < batten_design_result_count(design); i++) {
        const batten_feature_result *result = batten_design_result_at(design, i);
        if (result->value)
            sum = add_model(sum, result->value);
    }
    for (int i = 0; i < batten_design_output_count(design); i++) {
        /* A comparison states how long each curve took. */
        if (strcmp(batten_design_output_operation(design, i), "compare") == 0)
            continue;
        char *data = NULL;
        size_t size = 0;
        if (batten_design_output(design, i, NULL, NULL, &data, &size) == BATTEN_OK)
            sum = add_bytes(sum, data, size);
        batten_release(data);
    }
    return sum;
}

static void print_example(const batten_feature *feature, const char *folder)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/example.yaml", folder);
    batten_design_options options = batten_design_defaults();
    options.file_name = path;
    batten_text text = BATTEN_TEXT;
    batten_text_add(&text, "batten: 1\n%s", feature->example);
    batten_design *design = NULL;
    batten_status status =
        batten_design_parse(text.bytes, text.length, &options, NULL, &design);
    if (status == BATTEN_OK)
        status = batten_design_evaluate(design, NULL, NULL, NULL);
    const uint64_t sum = design ? add_results(start_of_sum, design) : start_of_sum;
    printf("%s %s %016llx\n", feature->name, batten_status_name(status),
           (unsigned long long)sum);
    batten_design_free(design);
    batten_text_free(&text);
}

int main(int count, char **arguments)
{
    const char *folder = count > 1 ? arguments[1] : ".";
    write_offsets(folder);
    for (int i = 0; i < batten_feature_count(); i++)
        if (batten_feature_at(i)->example)
            print_example(batten_feature_at(i), folder);
    return 0;
}
