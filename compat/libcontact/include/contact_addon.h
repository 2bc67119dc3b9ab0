/* libcontact: the functions of the program CONTACT's library, for vehicle codes that call it (C, Fortran, Python's
 * ctypes, MATLAB's loadlibrary). Names, arguments, units, codes and signs are CONTACT's of version 25.1; a program that
 * is written for it runs with this library instead. Each name exists with an underscore behind it as well.
 *
 * ire     result element, 1 to 999: a wheel on its rail (module 1) or up to nine contact problems (module 3)
 * icp     contact problem 1 to 9; in module 1, -1 is the wheel as a whole and 1, 2, ... are its contact patches
 * lengths count the numbers of an array; results beyond a length are left out
 *
 * An element is made by cntc_initialize, or by the first call that takes it: one of module 1 for icp = -1 and functions
 * without icp, one of module 3 for others.
 *
 * Every function returns a code: 0, or one of CNTC_err_..., or, from cntc_calculate, a number of elements > 0. Those of
 * CONTACT's that tell of errors by an argument ierror do so as well. A call that is refused sets nothing, and its
 * results are 0; why is written once into the log FOLDER/NAME.out. Nothing is printed, and no call ends the program.
 *
 * Different threads may work on different contact problems at the same time. A second thread that calls while one
 * works on the same problem gets CNTC_err_other.
 */
#ifndef CONTACT_ADDON_H
#define CONTACT_ADDON_H

#ifdef __cplusplus
extern "C" {
#endif

enum cntc_codes {
  /* the codes of flags, for cntc_setflags, cntc_getflags and cntc_setglobalflags */
  CNTC_if_units = 1933,  /* one of CNTC_un_...; profiles are in mm in any case */
  CNTC_ic_config = 1967, /* C: 0, 1 left, right wheel on a track; 4, 5 on rollers */
  CNTC_ic_pvtime = 1970, /* P: 0 goes on from the tractions of the call before, 2 begins anew */
  CNTC_ic_bound = 1971,  /* B: 0 full solution; 2, 3 elliptic, parabolic; 4 SDEC; 5 KPEC; 6 ANALYN */
  CNTC_ic_tang = 1972,   /* T: 0 frictionless, 1 shift, 2 transient rolling, 3 steady rolling */
  CNTC_ic_norm = 1973,   /* N: 0 position or approach, 1 vertical or normal force */
  CNTC_ic_force = 1974,  /* F */
  CNTC_ic_frclaw = 1976, /* L, to be read only */
  CNTC_ic_discns = 1977, /* D, of module 1 */
  CNTC_ic_inflcf = 1978, /* C3: 2 constant, 3 bilinear elements, 4 angle correction */
  CNTC_ic_mater = 1979,  /* M, to be read only */
  CNTC_ic_exrhs = 1980,  /* E, of module 3 */
  CNTC_ic_xflow = 1981,
  CNTC_ic_heat = 1982,   /* H, to be read only */
  CNTC_ic_iestim = 1983, /* I: 0 from nothing, 3 from the tractions of the call before */
  CNTC_ic_output = 1984, /* O: 1 to 6, how much of the results NAME.out has */
  CNTC_ic_flow = 1985,
  CNTC_ic_return = 1986, /* R: 0, 1 calculate; 2, 3 do not */
  CNTC_ic_matfil = 1987, /* A: 1, 2 writes the elements in contact, all, into a .mat file */
  CNTC_ic_sens = 1988,   /* S2: 0 none, 2 sensitivities of the normal, 3 of both problems */
  CNTC_ic_ifmeth = 1989,
  CNTC_ic_ifvari = 1990,
  CNTC_ic_sbsout = 1991, /* O_s: 1 to 4, of points inside into NAME.out */
  CNTC_ic_sbsfil = 1992, /* A_s: 1, 2 writes them into a .subs file */
  CNTC_ic_npomax = 1993, /* most elements of a potential contact of module 1 */
  CNTC_if_idebug = 2000,
  CNTC_if_licdbg = 2001,
  CNTC_if_wrtinp = 2002, /* 1 writes cases into NAME.inp */
  CNTC_if_openmp = 2003,
  CNTC_if_timers = 2004,
  CNTC_if_ncase = 2005, /* number of the last calculation, to be read only */

  /* units: length, speed; the body that forces act on */
  CNTC_un_cntc = 1934,  /* mm, mm/s; body 1, the rail */
  CNTC_un_spck = 1935,  /* m, m/s; body 2, the wheel */
  CNTC_un_si = 1936,    /* m, m/s; body 1 */
  CNTC_un_imper = 1937, /* there are none, as in CONTACT */

  /* kinds of input files */
  CNTC_inp_vamp = 1984,
  CNTC_inp_modul1 = 1988,
  CNTC_inp_spck = 1990,
  CNTC_inp_gensys = 1992,

  /* fields of elements */
  CNTC_fld_h = 1,
  CNTC_fld_mu = 2,
  CNTC_fld_px = 3,
  CNTC_fld_py = 4,
  CNTC_fld_pn = 5,
  CNTC_fld_ux = 7,
  CNTC_fld_uy = 8,
  CNTC_fld_un = 9,
  CNTC_fld_taucrt = 11,
  CNTC_fld_uplsx = 12,
  CNTC_fld_uplsy = 13,
  CNTC_fld_sx = 15,
  CNTC_fld_sy = 16,
  CNTC_fld_temp1 = 20,
  CNTC_fld_temp2 = 21,
  CNTC_fld_wx = 22,
  CNTC_fld_wy = 23,

  /* data for the heads of files */
  CNTC_mt_tim = 2011,
  CNTC_mt_xr = 2012,
  CNTC_mt_yr = 2013,
  CNTC_mt_xw = 2014,
  CNTC_mt_yw = 2015,
  CNTC_mt_sw = 2016,
  CNTC_mt_run = 2021,
  CNTC_mt_axle = 2022,
  CNTC_mt_side = 2023,

  /* what calls return */
  CNTC_err_allow = -12,  /* no licence: does not occur here */
  CNTC_err_search = -25, /* contact search */
  CNTC_err_ftot = -26,   /* a prescribed total force is not reached */
  CNTC_err_norm = -27,   /* normal problem not converged */
  CNTC_err_tang = -28,   /* tangential problem not converged */
  CNTC_err_tol = -29,    /* prescribed tangential force beyond friction */
  CNTC_err_icp = -31,    /* no such result element or contact problem */
  CNTC_err_profil = -32, /* a profile */
  CNTC_err_frclaw = -33, /* friction */
  CNTC_err_discr = -34,  /* potential contact and elements */
  CNTC_err_input = -39,  /* an input file */
  CNTC_err_other = -99   /* arguments, what is not supported, a problem in use by another thread */
};

/* Life cycle. Folders of one blank are the current one, an experiment of one blank is contact_addon. */
int cntc_initializefirst(int* ifcver, int* ierror, int* ioutput, const char* c_wrkdir, const char* c_outdir,
                         const char* c_expnam, int* len_wrkdir, int* len_outdir, int* len_expnam);
int cntc_initializefirst_new(int* ifcver, int* ierror, int* ioutput, const char* c_wrkdir, const char* c_outdir,
                             const char* c_expnam, int* len_wrkdir, int* len_outdir, int* len_expnam);
int cntc_initialize(int* ire, int* imodul, int* ifcver, int* ierror, const char* c_outdir, int* len_outdir);
int cntc_setfileunits(int* nunits, int* iunits);
int cntc_setglobalflags(int* lenflg, int* params, int* values);
int cntc_getmaxnumthreads(int* mxthrd);
int cntc_readinpfile(int* ire, int* inp_type, const char* c_fname, int* len_fname, int* ierror);
int cntc_finalize(int* ire);
int cntc_finalizelast(void);

/* Both modules; in module 1 with icp = -1. */
int cntc_setflags(int* ire, int* icp, int* lenflg, int* params, int* values);
int cntc_getflags(int* ire, int* icp, int* lenflg, int* params, int* values);
int cntc_setmetadata(int* ire, int* icp, int* lenmta, int* params, double* values);
int cntc_setsolverflags(int* ire, int* icp, int* gdigit, int* nints, int* iparam, int* nreals, double* rparam);
int cntc_setmaterialparameters(int* ire, int* icp, int* mdigit, int* nparam, double* rparam);
int cntc_setmaterialproperties(int* ire, int* icp, double* g1, double* nu1, double* g2, double* nu2);
int cntc_settemperaturedata(int* ire, int* icp, int* imeth, int* nparam, double* rparam);
int cntc_settimestep(int* ire, int* icp, double* dt);
int cntc_setrollingstepsize(int* ire, int* icp, double* chi, double* dq);
int cntc_setfrictionmethod(int* ire, int* icp, int* imeth, int* nparam, double* params);
int cntc_setpotcontact(int* ire, int* icp, int* ipotcn, int* nparam, double* rparam);
int cntc_settangentialforces(int* ire, int* icp, double* fx, double* fy);

/* Module 3. */
int cntc_setreferencevelocity(int* ire, int* icp, double* veloc);
int cntc_sethertzcontact(int* ire, int* icp, int* ipotcn, int* nparam, double* rparam);
int cntc_setpenetration(int* ire, int* icp, double* pen);
int cntc_setnormalforce(int* ire, int* icp, double* fn);
int cntc_setundeformeddistc(int* ire, int* icp, int* ibase, int* nparam, double* prmudf);
int cntc_setcreepages(int* ire, int* icp, double* vx, double* vy, double* phi);
int cntc_setextrarigidslip(int* ire, int* icp, int* lenarr, double* wx, double* wy);

/* Module 1. */
int cntc_setverticalforce(int* ire, double* fz);
int cntc_setprofileinputfname(int* ire, const char* c_fname, int* len_fname, int* nints, int* iparam, int* nreals,
                              double* rparam);
int cntc_setprofileinputvalues(int* ire, int* npoint, double* values, int* nints, int* iparam, int* nreals,
                               double* rparam);
int cntc_settrackdimensions(int* ire, int* ztrack, int* nparam, double* rparam);
int cntc_setwheelsetdimensions(int* ire, int* ewheel, int* nparam, double* rparam);
int cntc_setwheelsetposition(int* ire, int* ewheel, int* nparam, double* rparam);
int cntc_setwheelsetvelocity(int* ire, int* ewheel, int* nparam, double* rparam);
int cntc_setwheelsetflexibility(int* ire, int* ewheel, int* nparam, double* rparam);

/* Calculation. */
int cntc_calculate(int* ire, int* icp, int* ierror);
int cntc_getcalculationtime(int* ire, int* icp, double* tcpu, double* twall);
int cntc_resetcalculationtime(int* ire, int* icp);

/* Results of module 1. */
int cntc_getprofilevalues(int* ire, int* itask, int* nints, int* iparam, int* nreals, double* rparam, int* lenarr,
                          double* values);
int cntc_getprofilevalues_new(int* ire, int* itask, int* nints, int* iparam, int* nreals, double* rparam, int* lenarr,
                              double* values);
int cntc_getwheelsetposition(int* ire, int* lenarr, double* values);
int cntc_getwheelsetvelocity(int* ire, int* lenarr, double* values);
int cntc_getnumcontactpatches(int* ire, int* npatch);
int cntc_getcontactlocation(int* ire, int* icp, int* lenarr, double* values);
int cntc_getglobalforces(int* ire, int* icp, int* lenarr, double* values);

/* Results of a contact problem, or a patch. */
int cntc_getparameters(int* ire, int* icp, int* itask, int* lenarr, double* values);
int cntc_getreferencevelocity(int* ire, int* icp, double* veloc);
int cntc_gethertzcontact(int* ire, int* icp, int* lenarr, double* values);
int cntc_getnumelements(int* ire, int* icp, int* mx, int* my);
int cntc_getgriddiscretization(int* ire, int* icp, double* dx, double* dy);
int cntc_getpotcontact(int* ire, int* icp, int* lenarr, double* values);
int cntc_getpenetration(int* ire, int* icp, double* pen);
int cntc_getcreepages(int* ire, int* icp, double* vx, double* vy, double* phi);
int cntc_getcontactforces(int* ire, int* icp, double* fn, double* tx, double* ty, double* mz);
int cntc_getcontactpatchareas(int* ire, int* icp, double* carea, double* harea, double* sarea);
int cntc_getelementdivision(int* ire, int* icp, int* lenarr, int* eldiv);
int cntc_getmaximumpressure(int* ire, int* icp, double* pnmax);
int cntc_getmaximumtraction(int* ire, int* icp, double* ptmax);
int cntc_getmaximumtemperature(int* ire, int* icp, double* t1max, double* t2max);
int cntc_getfielddata(int* ire, int* icp, int* ifld, int* lenarr, double* fld);
int cntc_gettractions(int* ire, int* icp, int* lenarr, double* pn, double* px, double* py);
int cntc_getmicroslip(int* ire, int* icp, int* lenarr, double* sx, double* sy);
int cntc_getdisplacements(int* ire, int* icp, int* lenarr, double* un, double* ux, double* uy);
int cntc_getsensitivities(int* ire, int* icp, int* lenout, int* lenin, double* sens);

/* Displacements and stresses inside the bodies. */
int subs_addblock(int* ire, int* icp, int* iblk, int* isubs, int* nx, int* ny, int* nz, double* xparam, double* yparam,
                  double* zparam);
int subs_calculate(int* ire, int* icp, int* ierror);
int subs_getblocksize(int* ire, int* icp, int* iblk, int* nx, int* ny, int* nz);
int subs_getresults(int* ire, int* icp, int* iblk, int* lenarr, int* ncol, int* icol, double* values);

#ifdef __cplusplus
}
#endif

#endif
