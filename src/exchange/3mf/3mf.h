/* 3MF: a zip archive with a model in XML. It is written. Source: [3MF]. */
#ifndef BAT_3MF_H
#define BAT_3MF_H
#include <batten/exchange.h>
#include <batten/text.h>
#include <stdint.h>

/* Instances become components that share the meshes of their definition. */
batten_status bat_write_3mf(const batten_model *model, const batten_write_options *options,
                            batten_notes *notes, batten_text *text);

/* ---- archives (src/exchange/3mf/zip.c) ---- */

typedef struct {
    const char *name; /* ASCII */
    const char *bytes;
    size_t length;
} bat_zip_member;

/* An archive of members as they are, without compression, of 1 January 1980. Source: [ZIP]. */
batten_status bat_zip(int count, const bat_zip_member *members, batten_text *text);

#endif
