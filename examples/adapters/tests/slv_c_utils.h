/* What adams_gforce.c needs of Adams' header of this name: the arguments of a GFORCE's subroutine, and two utilities,
 * which adapters_test.cpp has. */
#ifndef SLV_C_UTILS_H
#define SLV_C_UTILS_H

#ifdef __cplusplus
extern "C" {
#endif

struct sAdamsGforce {
  int ID;
  int NPAR;
  const double* PAR;
  int I;
  int RM;
  int JFLOAT;
};
typedef void adams_c_Gfosub(const struct sAdamsGforce*, double, int, int, double*);

void c_sysary(const char* name, const int* parameters, int size, double* states, int* count, int* failed);
void c_errmes(int failed, const char* message, int id, const char* what);

#ifdef __cplusplus
}
#endif

#endif
