/* What the header of a .pcd file says. */
#ifndef BAT_PCD_HEADER_H
#define BAT_PCD_HEADER_H
#include "exchange/pcd/pcd.h"

enum { BAT_PCD_FIELDS = 100 };
typedef enum {
    BAT_PCD_NO_DATA,
    BAT_PCD_ASCII,
    BAT_PCD_BINARY,
    BAT_PCD_COMPRESSED
} bat_pcd_form;

typedef struct {
    bat_span name;
    int size, count;
    char type; /* I, U or F */
} bat_pcd_field;

typedef struct {
    bat_input *input;
    size_t at; /* behind the header */
    int line;
    bat_pcd_field fields[BAT_PCD_FIELDS];
    int field_count;
    size_t points, width, height;
    bool has_points;
    bat_pcd_form data;
    int axis[3]; /* the fields x, y, z */
    char *unpacked;
    bat_list read;  /* of double[3] */
    size_t nowhere; /* points that are NaN */
} bat_pcd_reading;

batten_status bat_pcd_read_header(bat_pcd_reading *r);

#endif
