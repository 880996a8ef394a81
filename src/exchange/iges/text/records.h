/*
 * The 80-column records of an IGES file, its global parameters, its directory, and the
 * parameters of an entity. What they mean is for entities.c.
 */
#ifndef BAT_IGES_RECORDS_H
#define BAT_IGES_RECORDS_H
#include "exchange/iges/text/parameters.h"

/* An entry of the directory. */
typedef struct {
    int id;                                         /* the odd number of its first record */
    int type, form, data, level, transform, colour; /* as they stand in its fields */
    int hidden, subordinate, use;                   /* of its status */
    int subscript;
    char label[9];
    int line;       /* of the file */
    bool is_broken; /* a field could not be read */
} bat_iges_entry;

/* Records of the parameter section at equal distances whose sequence numbers and lines count
 * on; all but a single one are whole. */
typedef struct {
    size_t at;           /* where the first stands in the file */
    size_t stride;       /* to the next */
    size_t place, count; /* of the first among all of the section; how many they are */
    int number;          /* its sequence number, or its place when the numbers are no good */
    int line;
    unsigned char columns; /* how many of the first 64 they have */
    bool is_damaged;
} bat_iges_run;

typedef struct {
    bat_input *input;
    bat_iges_delimiters delimiters;
    bat_iges_parameters global; /* those from the third on */
    bat_list directory;         /* the records of the directory */
    bat_list entries;           /* of bat_iges_entry, with rising ids */
    bat_list runs;              /* of bat_iges_run */
    size_t data_count;          /* records in them */
    size_t tokenised;           /* characters that were gone through so far */
    bool has_start, has_end;
    uint64_t tail; /* while records are read: the last eight columns of a record of the P
                      section, 0 for none, and the sequence number there */
    int number;
} bat_iges_file;

/* Take the file apart. */
batten_status bat_iges_begin(bat_input *input, bat_iges_file *file);
void bat_iges_end(bat_iges_file *file);
batten_status bat_iges_global(bat_iges_file *file);
/* The parameters of an entry, its type first. BAD_FORMAT, with a message for a note, when they
 * cannot be told apart. */
batten_status bat_iges_read_parameters(bat_iges_file *file, const bat_iges_entry *entry,
                                       bat_iges_parameters *parameters);

#endif
