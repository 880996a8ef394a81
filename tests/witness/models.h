/* What the makers of files for witnesses share. */
#ifndef TESTS_WITNESS_MODELS_H
#define TESTS_WITNESS_MODELS_H
#include <batten/batten.h>
#include <stdio.h>
#include <stdlib.h>

#define CHECK(call)                                               \
    do {                                                          \
        if ((call) != BATTEN_OK) {                                \
            fprintf(stderr, "%s: %s\n", #call, batten_message()); \
            exit(1);                                              \
        }                                                         \
    } while (0)

/* NAME.ENDING in the folder. */
FILE *open_beside(const char *name, const char *ending);
void put_file(const char *name, const char *ending, const batten_model *model,
              const batten_write_options *options);

/* Every format of meshes, and NAME.meshes. @param copies  of the same part */
void put_meshes(const char *name, const batten_model *model, int copies, double volume);
/* STEP and IGES files of what FreeCAD does not compare: points, layers, groups, what is hidden,
 * meshes. */
void put_marks(void);

#endif
