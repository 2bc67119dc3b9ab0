#ifndef MICROSLIP_H
#define MICROSLIP_H

/*
 * microslip from C, and from all that can call C: frictional rolling contact by the simplified theory (FASTSIM2) and by
 * the exact theory of elastic half-spaces, of two bodies, a wheel on a rail, and a wheelset.
 *
 * Units are SI. Forces, moments and tractions act on body 1, the wheel; positive creepage gives a negative force. Frame
 * and signs: docs/conventions.md.
 *
 * There are two interfaces. A problem (microslip_problem) is set input by input, by the paths that case files have,
 * solved, and asked for numbers by name: it has all that microslip can do. For inner loops contacts of FASTSIM2,
 * creep-force tables and wheels on rails are solved from plain arrays.
 *
 * Solvers stand behind handles: create, solve, get, destroy. Distinct handles may be used from distinct threads at the
 * same time, one handle by one thread at a time: a call with a handle that another thread is using is refused with
 * MICROSLIP_IN_USE. There is no global state but the creep-force table that microslip has, which is read once.
 *
 * Calls return a microslip_code, MICROSLIP_OK being 0. Those that are not made for an inner loop also take a
 * microslip_error, which may be NULL, and write into it what is wrong in words: field, value, unit and allowed range.
 * A call that refuses its arguments changes nothing else. No C++ exception leaves the library.
 *
 * Programs built with this header run with every later library of the same MICROSLIP_ABI. No function and no value goes
 * or means something else; structs without struct_size keep their layout; what grows does so at its end, in two ways.
 *
 * Structs that may get fields begin with `struct_size`, which their _init function or the caller sets to sizeof the
 * struct. Fields that the caller does not have are zero, which means the old behaviour.
 *
 * Numbers that may become more stand in lists (microslip_list), where they are found by name. Arrays have them in the
 * order of their list, in rows whose width the caller tells. New numbers stand at the end of a list, so that an index
 * that was found once stays, as do names and units. A row may be shorter than its list: what it leaves out is zero,
 * which means the old behaviour, or is not written. A row longer than its list is refused with MICROSLIP_WRONG_SIZE.
 */

#include <stddef.h>

/* Versions follow semver.org. */
#define MICROSLIP_VERSION_MAJOR 1
#define MICROSLIP_VERSION_MINOR 0
#define MICROSLIP_VERSION_PATCH 0
#define MICROSLIP_VERSION "1.0.0"

/* This binary interface: layouts, functions and meanings. Raised together with the soname, when programs built with
 * an older header no longer run with the library. */
#define MICROSLIP_ABI 2

#if defined(_WIN32) && defined(MICROSLIP_BUILDING_LIBRARY)
#define MICROSLIP_API __declspec(dllexport)
#elif defined(_WIN32)
#define MICROSLIP_API __declspec(dllimport)
#elif defined(__GNUC__)
#define MICROSLIP_API __attribute__((visibility("default")))
#else
#define MICROSLIP_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---------------------------------------------------------------------------------------------- codes and texts ----
 */

/* Outcome of a call or a contact. Values are never given another meaning. */
typedef enum microslip_code {
  MICROSLIP_OK = 0,
  /* How a calculation ended; also in `status` of the results. */
  MICROSLIP_INVALID_INPUT = 1, /* a contact is not a number or out of range; its results are NaN, others are solved */
  MICROSLIP_NOT_CONVERGED = 2, /* the result is the best one found; its residual is stated */
  MICROSLIP_NO_CONTACT = 3,    /* the bodies do not touch */
  MICROSLIP_NO_SOLUTION = 4,   /* a prescribed force exceeds mu Fn; the result is full sliding */
  MICROSLIP_OUT_OF_RANGE = 5,  /* beyond a creep-force table's range; the forces are those of limits */
  MICROSLIP_IMPLAUSIBLE = 6,   /* solved, but it cannot be meant, as its warnings say */
  /* Why a call was refused. */
  MICROSLIP_NULL_POINTER = 16,
  MICROSLIP_WRONG_SIZE = 17,     /* of an array or a struct */
  MICROSLIP_INVALID_OPTION = 18, /* an option or argument out of range */
  MICROSLIP_OUT_OF_MEMORY = 19,
  MICROSLIP_NO_RESULT = 20,      /* nothing was solved yet that this could be got from, or not this field */
  MICROSLIP_INTERNAL_ERROR = 21, /* a fault of the library; please report it */
  MICROSLIP_IN_USE = 22          /* another thread is in a call with this handle, or this one from within such a call */
} microslip_code;

#define MICROSLIP_ERROR_LENGTH 256

/* Code and text of an error. */
typedef struct microslip_error {
  int code;                          /* a microslip_code */
  char text[MICROSLIP_ERROR_LENGTH]; /* ends with a zero; cut if longer; empty with MICROSLIP_OK */
} microslip_error;

/* Identification of the library's build. Texts live as long as the library is loaded. */
typedef struct microslip_build {
  const char* version;    /* e.g. "1.0.0" */
  const char* commit;     /* short hash, with "-dirty" if there were changes; "unknown" outside a repository */
  const char* compiler;   /* name and version */
  const char* build_type; /* e.g. "Release" */
} microslip_build;

/* MICROSLIP_VERSION of the library that is running, while the macros above are of the header. */
MICROSLIP_API const char* microslip_version(void);
/* MICROSLIP_ABI of the running library. The linker checks it by the soname; a host that loads the library by its name
 * (dlopen, LoadLibrary, ctypes, loadlibrary of MATLAB) calls this first and goes on only if it returns the header's. */
MICROSLIP_API int microslip_abi(void);
MICROSLIP_API microslip_build microslip_build_info(void);
/* Meaning of a code, in a few words; never NULL. */
MICROSLIP_API const char* microslip_code_text(int code);

/* ------------------------------------------------------------------------------------------------------ contact ----
 */

/* Dependence of the coefficient of friction on the slip velocity v, with mu_k, d_i and v_i as in microslip_contact. */
typedef enum microslip_friction_law {
  MICROSLIP_COULOMB = 0,    /* mu_k */
  MICROSLIP_LINEAR = 1,     /* mu_k + sum of d_i max(0, 1 - v/(2 v_i)) */
  MICROSLIP_RATIONAL = 2,   /* mu_k + d_1/(1 + v/v_1) + d_2/(1 + (v/v_2)^2) */
  MICROSLIP_EXPONENTIAL = 3 /* mu_k + sum of d_i 2^(-v/v_i) */
} microslip_friction_law;

/* One Hertzian contact: ellipse, combined material, load, friction and creepages. */
typedef struct microslip_contact {
  /* Numbers that are > 0 lie in [1e-30, 1e30], creepages in [-1e30, 1e30]. */
  double a;                         /* semi-axis along the rolling direction [m], > 0 */
  double b;                         /* lateral semi-axis [m], > 0 */
  double shear_modulus;             /* combined G [Pa], > 0 */
  double poisson_ratio;             /* combined nu [-], in [0, 0.5] */
  double normal_force;              /* Fn [N], > 0 */
  double rolling_speed;             /* V [m/s], > 0; matters for falling friction and for powers only */
  double creepage_longitudinal;     /* xi [-] */
  double creepage_lateral;          /* eta [-] */
  double spin;                      /* phi [1/m] */
  double friction;                  /* mu, or mu_k of a falling law [-], in [0, 10], as is mu_k + d_1 + d_2 */
  int friction_law;                 /* a microslip_friction_law; derivatives of the exact theory take Coulomb's only */
  double friction_drop[2];          /* d_i [-], >= 0; not used by Coulomb's law */
  double friction_half_velocity[2]; /* v_i [m/s], > 0 where d_i > 0 */
} microslip_contact;

/* Checks that a contact is within the ranges above; if not, the error names the first field that is not. Any thread. */
MICROSLIP_API microslip_code microslip_contact_check(const microslip_contact* contact, microslip_error* error);

/* Polach's law mu_s ((1 - A) exp(-B v) + A), which is an exponential one, set in a contact: static coefficient mu_s in
 * [0, 10], ratio A in [0, 1], decay B [s/m], > 0. Any thread. */
MICROSLIP_API microslip_code microslip_polach_friction(double static_coefficient, double ratio, double decay,
                                                       microslip_contact* contact, microslip_error* error);

/* Totals, on body 1. */
typedef struct microslip_forces {
  double fx;            /* [N] */
  double fy;            /* [N] */
  double mz;            /* integral of x py - y px [N m] */
  double adhesion_area; /* [m^2] */
  double slip_area;     /* [m^2] */
  int status;           /* a microslip_code below 16 */
} microslip_forces;

/* Totals and their derivatives: rows fx, fy, mz; columns xi [-], eta [-], phi [1/m], Fn [N]. That to Fn keeps the
 * ellipse as it is. */
typedef struct microslip_derivatives {
  microslip_forces forces;
  double jacobian[3][4];
} microslip_derivatives;

/* Two bodies that touch at a point; index 0 is body 1. Radii are positive for convex bodies, negative for concave ones
 * and infinite for flat ones. */
typedef struct microslip_bodies {
  double rolling_radius[2];    /* in the plane of rolling [m] */
  double transverse_radius[2]; /* in the lateral plane [m] */
  double young_modulus[2];     /* E [Pa], > 0 */
  double poisson_ratio[2];     /* nu [-], in [0, 0.5] */
} microslip_bodies;

/* Results of Hertz's theory. */
typedef struct microslip_hertz {
  double a, b;          /* semi-axes along x and y [m] */
  double approach;      /* of distant points [m] */
  double peak_pressure; /* [Pa] */
  double stiffness;     /* dFn/d(approach) [N/m] */
  double shear_modulus; /* combined G [Pa] */
  double poisson_ratio; /* combined nu [-] */
  double dissimilarity; /* K [-], 0 for equal bodies */
} microslip_hertz;

/* Hertz's contact under a normal force [N], > 0. Cost: about a microsecond. Any thread. */
MICROSLIP_API microslip_code microslip_hertz_from_load(const microslip_bodies* bodies, double normal_force,
                                                       microslip_hertz* hertz, microslip_error* error);

/* Reasons why a contact is implausible for half-spaces, in lines with numbers and the inputs to check: an ellipse or an
 * approach that is large beside a radius of curvature, as lengths in mm or moduli in MPa make it. Empty for a plausible
 * contact. `text` is to be released by microslip_free_text. Any thread. */
MICROSLIP_API microslip_code microslip_hertz_warnings(const microslip_bodies* bodies, const microslip_hertz* hertz,
                                                      char** text, microslip_error* error);

/* Releases a text that this library made; NULL is allowed. */
MICROSLIP_API void microslip_free_text(char* text);

/* --------------------------------------------------------------------------------------------- names of choices ----
 */

typedef enum microslip_bound { MICROSLIP_PARABOLIC = 0, MICROSLIP_ELLIPTIC = 1 } microslip_bound;
typedef enum microslip_flexibility {
  MICROSLIP_THREE = 0,  /* one for each creepage */
  MICROSLIP_ONE = 1,    /* their weighted mean */
  MICROSLIP_BLENDED = 2 /* three at small creepages, one at large ones */
} microslip_flexibility;
typedef enum microslip_coefficients { MICROSLIP_KALKER = 0, MICROSLIP_COMPUTED = 1 } microslip_coefficients;
typedef enum microslip_precision { MICROSLIP_DOUBLE = 0, MICROSLIP_SINGLE = 1 } microslip_precision;
typedef enum microslip_direction { MICROSLIP_FORWARD = 0, MICROSLIP_BACKWARD = 1 } microslip_direction;

/* ------------------------------------------------------------------------------------------------------- lists ----
 */

/* Lists of numbers that have names, the same in files, C and Python. */
typedef enum microslip_list {
  MICROSLIP_CONTACT_QUANTITY = 0, /* of a contact, by either theory: "fx", "frictional_power" */
  MICROSLIP_CONTACT_FIELD = 1,    /* of a contact, a value for each element: "pressure", "gap" */
  MICROSLIP_WHEEL_STATE = 2,      /* what a wheel on a rail is given: "lateral", "vertical_force" */
  MICROSLIP_WHEEL_RESULT = 3,     /* forces on it: "force_y", "patch_count" */
  MICROSLIP_WHEEL_DERIVATIVE = 4, /* those of its results that have derivatives: "force_y", "vertical" */
  MICROSLIP_WHEEL_PATCH = 5,      /* of a patch of it: "normal_force", "status" */
  MICROSLIP_WHEELSET_CONTACT = 6, /* where a rigid wheelset touches: "left_contact_angle" */
  MICROSLIP_WHEELSET_RESULT = 7,  /* the forces on a wheelset: "moment_z", "roll" */
  /* Paths of the inputs of each microslip_kind: "load.normal_force". They stand in the order in which they are shown;
   * new ones may come between them, so that their paths last, and not their indices. */
  MICROSLIP_BODIES_INPUT = 8,
  MICROSLIP_WHEEL_INPUT = 9,
  MICROSLIP_WHEELSET_INPUT = 10
} microslip_list;

/* Kind of value of an input. */
typedef enum microslip_input_kind {
  MICROSLIP_NUMBER = 0,
  MICROSLIP_NUMBERS = 1, /* a list of at least one */
  MICROSLIP_WHOLE = 2,   /* a whole number */
  MICROSLIP_WHOLES = 3,  /* a list of two of them, or one for both */
  MICROSLIP_TEXT = 4,
  MICROSLIP_WORD = 5 /* one of a few */
} microslip_input_kind;

/* Description of a number in a list. Texts live as long as the library is loaded. */
typedef struct microslip_quantity {
  size_t struct_size; /* set by the caller */
  const char* name;
  const char* symbol;     /* in formulas; may be empty */
  const char* unit;       /* SI; "-" without one */
  const char* shift_unit; /* for a shift, whose creepages are lengths and whose power is work */
  const char* description;
  /* Of inputs; of results nothing is said here. */
  const char* range;        /* "in [0, 10]", "forward or backward"; may be empty */
  double least, largest;    /* between which it lies, infinite where nothing is */
  double missing;           /* what it is where it is not set; NaN: no number stands for it */
  const char* missing_word; /* the same of a word; empty: none */
  int kind;                 /* a microslip_input_kind */
} microslip_quantity;

/* Count of a microslip_list's numbers, which is the longest row; 0 if there is no such list. Any thread. */
MICROSLIP_API size_t microslip_count(int list);
/* Index of a number in a list, from 0; below 0 if it has none of this name, and the error names the nearest one.
 * Any thread. */
MICROSLIP_API int microslip_index(int list, const char* name, microslip_error* error);
/* Entry at an index below the count. Any thread. */
MICROSLIP_API microslip_code microslip_describe(int list, size_t index, microslip_quantity* quantity,
                                                microslip_error* error);

/* ----------------------------------------------------------------------------------------------------- FASTSIM2 ----
 */

typedef struct microslip_fastsim2 microslip_fastsim2;

typedef struct microslip_fastsim2_options {
  size_t struct_size;
  int mx, my;               /* cells along a row and rows, 1 to 10,000; 10 and 10 */
  int bound;                /* a microslip_bound; parabolic */
  int flexibility;          /* a microslip_flexibility; three */
  int coefficients;         /* a microslip_coefficients; Kalker's table */
  int direction;            /* a microslip_direction; forward */
  double slope_initial;     /* slope reduction: k0 in (0, 1]; 1 */
  double slope_at_infinity; /* alpha in [0, 1]; 1 */
  double slope_decay;       /* beta, >= 0; 0 */
  int precision; /* a microslip_precision; double. Single: forces of Coulomb friction to 1e-5 mu Fn in half the time */
} microslip_fastsim2_options;

/* Writes the defaults, and `struct_size`, into the first `size` bytes: pass sizeof *options. */
MICROSLIP_API microslip_code microslip_fastsim2_options_init(microslip_fastsim2_options* options, size_t size);
/* Makes a solver; options NULL means the defaults. All memory for solve and differentiate is taken here. */
MICROSLIP_API microslip_code microslip_fastsim2_create(const microslip_fastsim2_options* options,
                                                       microslip_fastsim2** solver, microslip_error* error);
/* NULL is allowed. */
MICROSLIP_API void microslip_fastsim2_destroy(microslip_fastsim2* solver);
/* Forces of `count` contacts. Real-time safe: no allocation, no lock, no input or output; the work is bounded by
 * count mx my. MICROSLIP_INVALID_INPUT if any contact is out of range (microslip_contact_check tells why): it gets NaN
 * and that status, the others are solved. A result does not depend on the other contacts. */
MICROSLIP_API microslip_code microslip_fastsim2_solve(microslip_fastsim2* solver, size_t count,
                                                      const microslip_contact* contacts, microslip_forces* forces);
/* Solves with derivatives, by forward differentiation of the same algorithm. Real-time safe as well. */
MICROSLIP_API microslip_code microslip_fastsim2_differentiate(microslip_fastsim2* solver, size_t count,
                                                              const microslip_contact* contacts,
                                                              microslip_derivatives* derivatives);
/* Solves one contact and keeps its fields, mx my cells, for the two calls below. Allocates. `forces` may be
 * NULL. */
MICROSLIP_API microslip_code microslip_fastsim2_solve_fields(microslip_fastsim2* solver,
                                                             const microslip_contact* contact, microslip_forces* forces,
                                                             microslip_error* error);
/* A number of the contact last solved by microslip_fastsim2_solve_fields, or a field of it, by the names of
 * MICROSLIP_CONTACT_QUANTITY and MICROSLIP_CONTACT_FIELD, and "state": 0 exterior, 1 adhesion, 2 slip. Fields have my
 * rows, y ascending, of mx cells, x ascending whatever the rolling direction; `count` must be mx my.
 * MICROSLIP_NO_RESULT for one that the simplified theory does not have. */
MICROSLIP_API microslip_code microslip_fastsim2_quantity(const microslip_fastsim2* solver, const char* name,
                                                         double* value, microslip_error* error);
MICROSLIP_API microslip_code microslip_fastsim2_field(const microslip_fastsim2* solver, const char* name, size_t count,
                                                      double* values, microslip_error* error);

/* A creep-force table: results of the exact theory, between which it interpolates. */
typedef struct microslip_creep_table microslip_creep_table;
/* Reads a table made by `microslip table make` for a microslip_direction, such as
 * share/microslip/python/microslip/hertz.creep of microslip, which is read once: handles of it share its numbers.
 * MICROSLIP_INVALID_OPTION for a file that is no table, of another version or byte order, cut short or corrupted. */
MICROSLIP_API microslip_code microslip_creep_table_read(const char* file, int direction, microslip_creep_table** table,
                                                        microslip_error* error);
/* NULL is allowed. */
MICROSLIP_API void microslip_creep_table_destroy(microslip_creep_table* table);
/* Forces of `count` contacts. Real-time safe: no allocation, no lock, no input or output, about 1 us a contact; from
 * several threads at a time. The code is the worst status of all: MICROSLIP_INVALID_INPUT for a contact out of range,
 * which gets NaN, MICROSLIP_OUT_OF_RANGE for one beyond the table, which gets the forces of a limit. */
MICROSLIP_API microslip_code microslip_creep_table_solve(const microslip_creep_table* table, size_t count,
                                                         const microslip_contact* contacts, microslip_forces* forces);
/* Solves with derivatives, those of the interpolation itself. */
MICROSLIP_API microslip_code microslip_creep_table_differentiate(const microslip_creep_table* table, size_t count,
                                                                 const microslip_contact* contacts,
                                                                 microslip_derivatives* derivatives);

/* ------------------------------------------------------------------------------------------------ force element ----
 */

/* Forces of a contact that remember creepages and loads before: the rational fit of its responses over the wavelength,
 * as `microslip respond --poles` writes it. Linear, for small changes about the steady state that it was fitted in. */
typedef struct microslip_force_element microslip_force_element;

/* Numbers of an input, xi, eta [-], phi [1/m], Fn [N], and of the forces, Fx, Fy [N], Mz [N m]. */
#define MICROSLIP_ELEMENT_INPUTS 4
#define MICROSLIP_ELEMENT_FORCES 3

/* Makes an element, in its steady state, from the text of a fit, a file's contents. */
MICROSLIP_API microslip_code microslip_force_element_create(const char* text, microslip_force_element** element,
                                                            microslip_error* error);
/* NULL is allowed. */
MICROSLIP_API void microslip_force_element_destroy(microslip_force_element* element);
/* Goes on by a distance rolled [m], at least 0, over which the inputs become `input`: exact where they are linear over
 * it. Real-time safe: no allocation, no lock. MICROSLIP_INVALID_INPUT for numbers that are not finite or a distance
 * below 0, which change nothing. */
MICROSLIP_API microslip_code microslip_force_element_step(microslip_force_element* element, double distance,
                                                          const double input[MICROSLIP_ELEMENT_INPUTS],
                                                          double forces[MICROSLIP_ELEMENT_FORCES]);
/* Back to where the inputs have always been `input`; NULL: those of the steady state. Real-time safe. */
MICROSLIP_API microslip_code microslip_force_element_reset(microslip_force_element* element, const double* input);
/* The memory, for integrators that go back: its count of numbers, which is 0 for NULL, a copy of it, and that copy put
 * back. Real-time safe. `count` must be that count. */
MICROSLIP_API size_t microslip_force_element_state_size(const microslip_force_element* element);
MICROSLIP_API microslip_code microslip_force_element_get_state(const microslip_force_element* element, size_t count,
                                                               double* state);
MICROSLIP_API microslip_code microslip_force_element_set_state(microslip_force_element* element, size_t count,
                                                               const double* state);

/* ----------------------------------------------------------------------------------------------------- problems ----
 */

/* Which problems there are, as kinds of case files. */
typedef enum microslip_kind {
  MICROSLIP_BODIES = 0,  /* two bodies that touch in an ellipse */
  MICROSLIP_WHEEL = 1,   /* a wheel on a rail by their profiles */
  MICROSLIP_WHEELSET = 2 /* both wheels of a wheelset */
} microslip_kind;

/* A problem: its inputs, a solver that keeps what does not change from one solve to the next, and what was solved last.
 * Inputs have paths, section and key of a case file, "load.normal_force"; the lists MICROSLIP_BODIES_INPUT and so on
 * tell them all with units, ranges and defaults. A library that was built without case files makes no problem:
 * MICROSLIP_NO_RESULT. */
typedef struct microslip_problem microslip_problem;

/* Makes one of a microslip_kind, in which nothing is set. Files of profiles and tables start at the working folder. */
MICROSLIP_API microslip_code microslip_problem_create(int kind, microslip_problem** problem, microslip_error* error);
/* Makes one with the inputs that the text of a case file has; `name` is the file's name for messages, and files of
 * profiles and tables start at its folder. */
MICROSLIP_API microslip_code microslip_problem_read(const char* text, const char* name, microslip_problem** problem,
                                                    microslip_error* error);
/* NULL is allowed. */
MICROSLIP_API void microslip_problem_destroy(microslip_problem* problem);
/* The text of the case file that has these inputs, for `microslip solve` and microslip_solve_case; to be released by
 * microslip_free_text. */
MICROSLIP_API microslip_code microslip_problem_text(const microslip_problem* problem, char** text,
                                                    microslip_error* error);

/* Set an input: a number in SI units, whole ones too; a word, a file, or a number with its unit, "80 kN"; a list of
 * numbers, such as the two of "solution.grid". MICROSLIP_INVALID_OPTION for what the path cannot be, with path, value,
 * unit and range in the error, and for an unknown path, with the nearest one. Incompatible inputs are refused when
 * it is solved. */
MICROSLIP_API microslip_code microslip_set(microslip_problem* problem, const char* path, double value,
                                           microslip_error* error);
MICROSLIP_API microslip_code microslip_set_text(microslip_problem* problem, const char* path, const char* value,
                                                microslip_error* error);
MICROSLIP_API microslip_code microslip_set_array(microslip_problem* problem, const char* path, size_t count,
                                                 const double* values, microslip_error* error);
/* Goes back to the default, as for "load.normal_force" before "load.approach" is set. */
MICROSLIP_API microslip_code microslip_unset(microslip_problem* problem, const char* path, microslip_error* error);
/* An input as it was set, in SI units, or its default. MICROSLIP_NO_RESULT if it has neither. A text is to be released
 * by microslip_free_text. Of a list `count` becomes its length; MICROSLIP_WRONG_SIZE if that is above `capacity`; with
 * `values` NULL it is only counted. */
MICROSLIP_API microslip_code microslip_get(const microslip_problem* problem, const char* path, double* value,
                                           microslip_error* error);
MICROSLIP_API microslip_code microslip_get_text(const microslip_problem* problem, const char* path, char** value,
                                                microslip_error* error);
MICROSLIP_API microslip_code microslip_get_array(const microslip_problem* problem, const char* path, size_t capacity,
                                                 double* values, size_t* count, microslip_error* error);

/* If not NULL: `progress` is called often by long solves with the fraction done, 0 to 1; another return than 0 ends the
 * solve with MICROSLIP_NOT_CONVERGED, and what there is by then. It must not call the same handle. */
MICROSLIP_API microslip_code microslip_set_progress(microslip_problem* problem,
                                                    int (*progress)(double fraction, void* data), void* data,
                                                    microslip_error* error);
/* Solves the problem by its solution.theory, and keeps the result. Returns its status, with the reason in the error, or
 * why it was refused; then the result before is kept. A profile is read again only where something of its file
 * was set. A sweep, points inside the bodies and creep curves are for microslip_solve_case. */
MICROSLIP_API microslip_code microslip_solve(microslip_problem* problem, microslip_error* error);
/* Solves steady rolling of two bodies by the exact theory with derivatives: `jacobian` holds count = 9 numbers, row by
 * row fx, fy, mz, by xi, eta, phi; NaN where there is no result. Some four to six times the cost of a solve. For
 * Coulomb friction; not with an accuracy or a force given. */
MICROSLIP_API microslip_code microslip_differentiate(microslip_problem* problem, size_t count, double* jacobian,
                                                     microslip_error* error);
/* A number of the result by its name: of two bodies one of MICROSLIP_CONTACT_QUANTITY, with solution.accuracy the
 * extrapolated ones; of a wheel of MICROSLIP_WHEEL_RESULT; of a wheelset of MICROSLIP_WHEELSET_RESULT, or of one of its
 * wheels, "left.force_y". Of two bodies with inputs of "material" wear and fatigue, too: "t_gamma", "worn_area", and
 * so on, and as fields "friction_work", "wear_depth", "shear_excess". MICROSLIP_NO_RESULT for one that two bodies do
 * not have, such as temperatures without heat data; NaN for what a wheel does not have, as Y/Q without a vertical
 * force. */
MICROSLIP_API microslip_code microslip_number(const microslip_problem* problem, const char* name, double* value,
                                              microslip_error* error);
/* A field of the result by its name, and its size. Of two bodies one of MICROSLIP_CONTACT_FIELD, or "state": 0
 * exterior, 1 adhesion, 2 slip; rows of elements, y ascending, in each of which x ascends whatever the rolling
 * direction, margins outside the contact included; the first call for "gap" may solve a normal problem. Of a wheel one
 * of MICROSLIP_WHEEL_PATCH, a row with a value for each patch; of a wheelset "left.normal_force" and so on. `count`
 * must be columns times rows. MICROSLIP_NO_RESULT for one that this result does not have. */
MICROSLIP_API microslip_code microslip_field_size(const microslip_problem* problem, const char* name, size_t* columns,
                                                  size_t* rows, microslip_error* error);
MICROSLIP_API microslip_code microslip_field(microslip_problem* problem, const char* name, size_t count, double* values,
                                             microslip_error* error);

/* --------------------------------------------------------------------------------------------------- case files ----
 */

/* Solves a case as `microslip solve CASE.toml --json` does. `text` is the case file's, `name` its name for messages.
 * `json` becomes the document as UTF-8, to be released by microslip_free_text: the numbers of a result file but its
 * fields, by the names that they have there, `units`, `status`, `warnings`. With a status other than MICROSLIP_OK it is
 * made as well; NULL if the case is refused, and the error has file, line, key, value and range. Profiles of a wheel on
 * a rail are read from paths that start at the folder of `name`. A library that was built without case files returns
 * MICROSLIP_NO_RESULT. Any thread. */
MICROSLIP_API microslip_code microslip_solve_case(const char* text, const char* name, char** json,
                                                  microslip_error* error);

/* ------------------------------------------------------------------------------------------------ wheel on rail ----
 */

/* A wheel on a rail by their profiles; see docs/wheel-on-rail.md for axes and signs: x forward, y to the left, z up. */
typedef struct microslip_wheel_rail microslip_wheel_rail;

/* Makes one of a problem of kind MICROSLIP_WHEEL as its inputs are now; it does not depend on the problem then. */
MICROSLIP_API microslip_code microslip_wheel_rail_create(const microslip_problem* problem,
                                                         microslip_wheel_rail** wheel_rail, microslip_error* error);
/* NULL is allowed. */
MICROSLIP_API void microslip_wheel_rail_destroy(microslip_wheel_rail* wheel_rail);
/* The state that the problem has, of a sweep the first one: the first `width` numbers of MICROSLIP_WHEEL_STATE. */
MICROSLIP_API microslip_code microslip_wheel_rail_state(const microslip_wheel_rail* wheel_rail, size_t width,
                                                        double* state);
/* Forces on a wheel in `count` states, one after another. `states` has a row of state_width numbers for each state,
 * the first of MICROSLIP_WHEEL_STATE, in SI units: the state of the wheelset with all that concerns one of its wheels.
 * With a `vertical_force` other than 0 the height is found for it, else that of `vertical` counts. `results` gets a row
 * of result_width numbers, the first of MICROSLIP_WHEEL_RESULT, and `status` a microslip_code below 16; each is written
 * for every state, and may be NULL if it is not wanted (result_width 0). Forces act on the wheel, in track axes; the
 * moment is about its centre; NaN stands for what there is not, as Y/Q without a vertical force. With the theory
 * "fastsim2" it takes no memory while there are at most 8 patches, and throws nothing, unless material.hardness asks
 * for wear. The code is that of the first state that is not MICROSLIP_OK. A state that the lack of memory or a fault of
 * the library leaves unsolved is MICROSLIP_NOT_CONVERGED with a residual of 1, and the code says why. */
MICROSLIP_API microslip_code microslip_wheel_rail_solve(microslip_wheel_rail* wheel_rail, size_t count,
                                                        size_t state_width, const double* states, size_t result_width,
                                                        double* results, int* status);
/* Solves the steps of a simulation: each state starts from the one before, the first one from the last state of
 * the call before, which takes half of the time where they are near each other and changes results by about the
 * tolerance. */
MICROSLIP_API microslip_code microslip_wheel_rail_continue(microslip_wheel_rail* wheel_rail, size_t count,
                                                           size_t state_width, const double* states,
                                                           size_t result_width, double* results, int* status);
/* Solves with derivatives, which hold where no patch comes or goes. `jacobian` gets a matrix for
 * each state, row by row: the first row_count numbers of MICROSLIP_WHEEL_DERIVATIVE by the first column_count ones of
 * MICROSLIP_WHEEL_STATE, in SI units. Derivatives by what was not given are zero: by `vertical` with a vertical force,
 * by `vertical_force` without one; so are all of a state that is neither MICROSLIP_OK nor MICROSLIP_IMPLAUSIBLE. With
 * the theory "fastsim2" some three solves, and no memory either. */
MICROSLIP_API microslip_code microslip_wheel_rail_differentiate(microslip_wheel_rail* wheel_rail, size_t count,
                                                                size_t state_width, const double* states,
                                                                size_t result_width, double* results, int* status,
                                                                size_t row_count, size_t column_count,
                                                                double* jacobian);
/* The patches of the state last solved, from the gauge to the field side of a left wheel: `values` gets a row of
 * `width` numbers for each, the first of MICROSLIP_WHEEL_PATCH; `count` becomes how many there are, whatever space
 * is. MICROSLIP_WRONG_SIZE, and no patch, if they are more than `capacity` rows. With `values` NULL they are only
 * counted. Takes no memory unless it is refused. MICROSLIP_NO_RESULT before a state was solved. */
MICROSLIP_API microslip_code microslip_wheel_rail_patches(const microslip_wheel_rail* wheel_rail, size_t width,
                                                          size_t capacity, double* values, size_t* count,
                                                          microslip_error* error);
/* The text of the k-th warning, counted from 0, which is bit k of a wheel's `warning_code`; NULL from the first that
 * there is not. It lasts. Any thread. */
MICROSLIP_API const char* microslip_warning(int k);

/* Condition that decides the roll angle of a rigid wheelset. */
typedef enum microslip_roll_rule {
  MICROSLIP_ROLL_EQUILIBRIUM = 0, /* both wheels touch their rails */
  MICROSLIP_ROLL_NONE = 1         /* zero, as in the reference calculations of EN 15302 */
} microslip_roll_rule;

/* Contacts of a rigid wheelset with the profiles, track and wheelset of the case on both sides, at `count` lateral
 * displacements [m] of a yaw angle [rad], each in [-1, 1], by a microslip_roll_rule. `contacts` gets a row of `width`
 * numbers for each, the first of MICROSLIP_WHEELSET_CONTACT, and `status` a microslip_code below 16, or is NULL;
 * numbers of one that is not MICROSLIP_OK may be NaN. The code is that of the first that is not MICROSLIP_OK. */
MICROSLIP_API microslip_code microslip_wheelset_contacts(microslip_wheel_rail* wheel_rail, int roll, double yaw,
                                                         size_t count, const double* lateral, size_t width,
                                                         double* contacts, int* status, microslip_error* error);
/* Equivalent conicity [-] by EN 15302 at `count` amplitudes [m], in (0, 0.9]; contact_distance e [m], > 0, is that of
 * both contacts, usually 1.5. NaN where no periodic motion exists, and for an amplitude out of range, for which the
 * code is MICROSLIP_INVALID_INPUT; the others are found. The nonlinearity parameter is the difference of those at 4 and
 * 2 mm over 2 mm. */
MICROSLIP_API microslip_code microslip_equivalent_conicity(microslip_wheel_rail* wheel_rail, int roll,
                                                           double contact_distance, size_t count,
                                                           const double* amplitudes, double* conicity,
                                                           microslip_error* error);

#ifdef __cplusplus
}
#endif

#endif
