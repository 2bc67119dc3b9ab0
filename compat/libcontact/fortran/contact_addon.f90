! The functions of contact_addon.h for Fortran: the same calls as with CONTACT's interface file. What each does, and
! the codes, are told there.
module contact_addon
  use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int
  implicit none
  private :: c_char, c_double, c_int

  integer(c_int), parameter :: CNTC_if_units = 1933
  integer(c_int), parameter :: CNTC_ic_config = 1967
  integer(c_int), parameter :: CNTC_ic_pvtime = 1970
  integer(c_int), parameter :: CNTC_ic_bound = 1971
  integer(c_int), parameter :: CNTC_ic_tang = 1972
  integer(c_int), parameter :: CNTC_ic_norm = 1973
  integer(c_int), parameter :: CNTC_ic_force = 1974
  integer(c_int), parameter :: CNTC_ic_frclaw = 1976
  integer(c_int), parameter :: CNTC_ic_discns = 1977
  integer(c_int), parameter :: CNTC_ic_inflcf = 1978
  integer(c_int), parameter :: CNTC_ic_mater = 1979
  integer(c_int), parameter :: CNTC_ic_exrhs = 1980
  integer(c_int), parameter :: CNTC_ic_xflow = 1981
  integer(c_int), parameter :: CNTC_ic_heat = 1982
  integer(c_int), parameter :: CNTC_ic_iestim = 1983
  integer(c_int), parameter :: CNTC_ic_output = 1984
  integer(c_int), parameter :: CNTC_ic_flow = 1985
  integer(c_int), parameter :: CNTC_ic_return = 1986
  integer(c_int), parameter :: CNTC_ic_matfil = 1987
  integer(c_int), parameter :: CNTC_ic_sens = 1988
  integer(c_int), parameter :: CNTC_ic_ifmeth = 1989
  integer(c_int), parameter :: CNTC_ic_ifvari = 1990
  integer(c_int), parameter :: CNTC_ic_sbsout = 1991
  integer(c_int), parameter :: CNTC_ic_sbsfil = 1992
  integer(c_int), parameter :: CNTC_ic_npomax = 1993
  integer(c_int), parameter :: CNTC_if_idebug = 2000
  integer(c_int), parameter :: CNTC_if_licdbg = 2001
  integer(c_int), parameter :: CNTC_if_wrtinp = 2002
  integer(c_int), parameter :: CNTC_if_openmp = 2003
  integer(c_int), parameter :: CNTC_if_timers = 2004
  integer(c_int), parameter :: CNTC_if_ncase = 2005
  integer(c_int), parameter :: CNTC_un_cntc = 1934
  integer(c_int), parameter :: CNTC_un_spck = 1935
  integer(c_int), parameter :: CNTC_un_si = 1936
  integer(c_int), parameter :: CNTC_un_imper = 1937
  integer(c_int), parameter :: CNTC_inp_vamp = 1984
  integer(c_int), parameter :: CNTC_inp_modul1 = 1988
  integer(c_int), parameter :: CNTC_inp_spck = 1990
  integer(c_int), parameter :: CNTC_inp_gensys = 1992
  integer(c_int), parameter :: CNTC_fld_h = 1
  integer(c_int), parameter :: CNTC_fld_mu = 2
  integer(c_int), parameter :: CNTC_fld_px = 3
  integer(c_int), parameter :: CNTC_fld_py = 4
  integer(c_int), parameter :: CNTC_fld_pn = 5
  integer(c_int), parameter :: CNTC_fld_ux = 7
  integer(c_int), parameter :: CNTC_fld_uy = 8
  integer(c_int), parameter :: CNTC_fld_un = 9
  integer(c_int), parameter :: CNTC_fld_taucrt = 11
  integer(c_int), parameter :: CNTC_fld_uplsx = 12
  integer(c_int), parameter :: CNTC_fld_uplsy = 13
  integer(c_int), parameter :: CNTC_fld_sx = 15
  integer(c_int), parameter :: CNTC_fld_sy = 16
  integer(c_int), parameter :: CNTC_fld_temp1 = 20
  integer(c_int), parameter :: CNTC_fld_temp2 = 21
  integer(c_int), parameter :: CNTC_fld_wx = 22
  integer(c_int), parameter :: CNTC_fld_wy = 23
  integer(c_int), parameter :: CNTC_mt_tim = 2011
  integer(c_int), parameter :: CNTC_mt_xr = 2012
  integer(c_int), parameter :: CNTC_mt_yr = 2013
  integer(c_int), parameter :: CNTC_mt_xw = 2014
  integer(c_int), parameter :: CNTC_mt_yw = 2015
  integer(c_int), parameter :: CNTC_mt_sw = 2016
  integer(c_int), parameter :: CNTC_mt_run = 2021
  integer(c_int), parameter :: CNTC_mt_axle = 2022
  integer(c_int), parameter :: CNTC_mt_side = 2023
  integer(c_int), parameter :: CNTC_err_allow = -12
  integer(c_int), parameter :: CNTC_err_search = -25
  integer(c_int), parameter :: CNTC_err_ftot = -26
  integer(c_int), parameter :: CNTC_err_norm = -27
  integer(c_int), parameter :: CNTC_err_tang = -28
  integer(c_int), parameter :: CNTC_err_tol = -29
  integer(c_int), parameter :: CNTC_err_icp = -31
  integer(c_int), parameter :: CNTC_err_profil = -32
  integer(c_int), parameter :: CNTC_err_frclaw = -33
  integer(c_int), parameter :: CNTC_err_discr = -34
  integer(c_int), parameter :: CNTC_err_input = -39
  integer(c_int), parameter :: CNTC_err_other = -99

  interface
    subroutine cntc_initializefirst(ifcver, ierror, ioutput, c_wrkdir, c_outdir, c_expnam, len_wrkdir, &
        len_outdir, len_expnam) bind(c)
      import :: c_char, c_int
      integer(c_int) :: ifcver, ierror, ioutput, len_wrkdir, len_outdir, len_expnam
      character(kind=c_char), intent(in) :: c_wrkdir(*), c_outdir(*), c_expnam(*)
    end subroutine cntc_initializefirst

    subroutine cntc_initializefirst_new(ifcver, ierror, ioutput, c_wrkdir, c_outdir, c_expnam, len_wrkdir, &
        len_outdir, len_expnam) bind(c)
      import :: c_char, c_int
      integer(c_int) :: ifcver, ierror, ioutput, len_wrkdir, len_outdir, len_expnam
      character(kind=c_char), intent(in) :: c_wrkdir(*), c_outdir(*), c_expnam(*)
    end subroutine cntc_initializefirst_new

    subroutine cntc_initialize(ire, imodul, ifcver, ierror, c_outdir, len_outdir) bind(c)
      import :: c_char, c_int
      integer(c_int) :: ire, imodul, ifcver, ierror, len_outdir
      character(kind=c_char), intent(in) :: c_outdir(*)
    end subroutine cntc_initialize

    subroutine cntc_setfileunits(nunits, iunits) bind(c)
      import :: c_int
      integer(c_int) :: nunits, iunits(*)
    end subroutine cntc_setfileunits

    subroutine cntc_setglobalflags(lenflg, params, values) bind(c)
      import :: c_int
      integer(c_int) :: lenflg, params(*), values(*)
    end subroutine cntc_setglobalflags

    subroutine cntc_getmaxnumthreads(mxthrd) bind(c)
      import :: c_int
      integer(c_int) :: mxthrd
    end subroutine cntc_getmaxnumthreads

    subroutine cntc_readinpfile(ire, inp_type, c_fname, len_fname, ierror) bind(c)
      import :: c_char, c_int
      integer(c_int) :: ire, inp_type, len_fname, ierror
      character(kind=c_char), intent(in) :: c_fname(*)
    end subroutine cntc_readinpfile

    subroutine cntc_finalize(ire) bind(c)
      import :: c_int
      integer(c_int) :: ire
    end subroutine cntc_finalize

    subroutine cntc_finalizelast() bind(c)
    end subroutine cntc_finalizelast

    subroutine cntc_setflags(ire, icp, lenflg, params, values) bind(c)
      import :: c_int
      integer(c_int) :: ire, icp, lenflg, params(*), values(*)
    end subroutine cntc_setflags

    subroutine cntc_getflags(ire, icp, lenflg, params, values) bind(c)
      import :: c_int
      integer(c_int) :: ire, icp, lenflg, params(*), values(*)
    end subroutine cntc_getflags

    subroutine cntc_setmetadata(ire, icp, lenmta, params, values) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, lenmta, params(*)
      real(c_double) :: values(*)
    end subroutine cntc_setmetadata

    subroutine cntc_setsolverflags(ire, icp, gdigit, nints, iparam, nreals, rparam) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, gdigit, nints, iparam(*), nreals
      real(c_double) :: rparam(*)
    end subroutine cntc_setsolverflags

    subroutine cntc_setmaterialparameters(ire, icp, mdigit, nparam, rparam) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, mdigit, nparam
      real(c_double) :: rparam(*)
    end subroutine cntc_setmaterialparameters

    subroutine cntc_setmaterialproperties(ire, icp, g1, nu1, g2, nu2) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp
      real(c_double) :: g1, nu1, g2, nu2
    end subroutine cntc_setmaterialproperties

    subroutine cntc_settemperaturedata(ire, icp, imeth, nparam, rparam) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, imeth, nparam
      real(c_double) :: rparam(*)
    end subroutine cntc_settemperaturedata

    subroutine cntc_settimestep(ire, icp, dt) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp
      real(c_double) :: dt
    end subroutine cntc_settimestep

    subroutine cntc_setrollingstepsize(ire, icp, chi, dq) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp
      real(c_double) :: chi, dq
    end subroutine cntc_setrollingstepsize

    subroutine cntc_setfrictionmethod(ire, icp, imeth, nparam, params) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, imeth, nparam
      real(c_double) :: params(*)
    end subroutine cntc_setfrictionmethod

    subroutine cntc_setpotcontact(ire, icp, ipotcn, nparam, rparam) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, ipotcn, nparam
      real(c_double) :: rparam(*)
    end subroutine cntc_setpotcontact

    subroutine cntc_settangentialforces(ire, icp, fx, fy) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp
      real(c_double) :: fx, fy
    end subroutine cntc_settangentialforces

    subroutine cntc_setreferencevelocity(ire, icp, veloc) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp
      real(c_double) :: veloc
    end subroutine cntc_setreferencevelocity

    subroutine cntc_sethertzcontact(ire, icp, ipotcn, nparam, rparam) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, ipotcn, nparam
      real(c_double) :: rparam(*)
    end subroutine cntc_sethertzcontact

    subroutine cntc_setpenetration(ire, icp, pen) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp
      real(c_double) :: pen
    end subroutine cntc_setpenetration

    subroutine cntc_setnormalforce(ire, icp, fn) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp
      real(c_double) :: fn
    end subroutine cntc_setnormalforce

    subroutine cntc_setundeformeddistc(ire, icp, ibase, nparam, prmudf) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, ibase, nparam
      real(c_double) :: prmudf(*)
    end subroutine cntc_setundeformeddistc

    subroutine cntc_setcreepages(ire, icp, vx, vy, phi) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp
      real(c_double) :: vx, vy, phi
    end subroutine cntc_setcreepages

    subroutine cntc_setextrarigidslip(ire, icp, lenarr, wx, wy) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, lenarr
      real(c_double) :: wx(*), wy(*)
    end subroutine cntc_setextrarigidslip

    subroutine cntc_setverticalforce(ire, fz) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire
      real(c_double) :: fz
    end subroutine cntc_setverticalforce

    subroutine cntc_setprofileinputfname(ire, c_fname, len_fname, nints, iparam, nreals, rparam) bind(c)
      import :: c_char, c_double, c_int
      integer(c_int) :: ire, len_fname, nints, iparam(*), nreals
      character(kind=c_char), intent(in) :: c_fname(*)
      real(c_double) :: rparam(*)
    end subroutine cntc_setprofileinputfname

    subroutine cntc_setprofileinputvalues(ire, npoint, values, nints, iparam, nreals, rparam) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, npoint, nints, iparam(*), nreals
      real(c_double) :: values(*), rparam(*)
    end subroutine cntc_setprofileinputvalues

    subroutine cntc_settrackdimensions(ire, ztrack, nparam, rparam) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, ztrack, nparam
      real(c_double) :: rparam(*)
    end subroutine cntc_settrackdimensions

    subroutine cntc_setwheelsetdimensions(ire, ewheel, nparam, rparam) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, ewheel, nparam
      real(c_double) :: rparam(*)
    end subroutine cntc_setwheelsetdimensions

    subroutine cntc_setwheelsetposition(ire, ewheel, nparam, rparam) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, ewheel, nparam
      real(c_double) :: rparam(*)
    end subroutine cntc_setwheelsetposition

    subroutine cntc_setwheelsetvelocity(ire, ewheel, nparam, rparam) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, ewheel, nparam
      real(c_double) :: rparam(*)
    end subroutine cntc_setwheelsetvelocity

    subroutine cntc_setwheelsetflexibility(ire, ewheel, nparam, rparam) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, ewheel, nparam
      real(c_double) :: rparam(*)
    end subroutine cntc_setwheelsetflexibility

    subroutine cntc_calculate(ire, icp, ierror) bind(c)
      import :: c_int
      integer(c_int) :: ire, icp, ierror
    end subroutine cntc_calculate

    subroutine cntc_getcalculationtime(ire, icp, tcpu, twall) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp
      real(c_double) :: tcpu, twall
    end subroutine cntc_getcalculationtime

    subroutine cntc_resetcalculationtime(ire, icp) bind(c)
      import :: c_int
      integer(c_int) :: ire, icp
    end subroutine cntc_resetcalculationtime

    subroutine cntc_getprofilevalues(ire, itask, nints, iparam, nreals, rparam, lenarr, values) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, itask, nints, iparam(*), nreals, lenarr
      real(c_double) :: rparam(*), values(*)
    end subroutine cntc_getprofilevalues

    subroutine cntc_getprofilevalues_new(ire, itask, nints, iparam, nreals, rparam, lenarr, values) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, itask, nints, iparam(*), nreals, lenarr
      real(c_double) :: rparam(*), values(*)
    end subroutine cntc_getprofilevalues_new

    subroutine cntc_getwheelsetposition(ire, lenarr, values) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, lenarr
      real(c_double) :: values(*)
    end subroutine cntc_getwheelsetposition

    subroutine cntc_getwheelsetvelocity(ire, lenarr, values) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, lenarr
      real(c_double) :: values(*)
    end subroutine cntc_getwheelsetvelocity

    subroutine cntc_getnumcontactpatches(ire, npatch) bind(c)
      import :: c_int
      integer(c_int) :: ire, npatch
    end subroutine cntc_getnumcontactpatches

    subroutine cntc_getcontactlocation(ire, icp, lenarr, values) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, lenarr
      real(c_double) :: values(*)
    end subroutine cntc_getcontactlocation

    subroutine cntc_getglobalforces(ire, icp, lenarr, values) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, lenarr
      real(c_double) :: values(*)
    end subroutine cntc_getglobalforces

    subroutine cntc_getparameters(ire, icp, itask, lenarr, values) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, itask, lenarr
      real(c_double) :: values(*)
    end subroutine cntc_getparameters

    subroutine cntc_getreferencevelocity(ire, icp, veloc) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp
      real(c_double) :: veloc
    end subroutine cntc_getreferencevelocity

    subroutine cntc_gethertzcontact(ire, icp, lenarr, values) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, lenarr
      real(c_double) :: values(*)
    end subroutine cntc_gethertzcontact

    subroutine cntc_getnumelements(ire, icp, mx, my) bind(c)
      import :: c_int
      integer(c_int) :: ire, icp, mx, my
    end subroutine cntc_getnumelements

    subroutine cntc_getgriddiscretization(ire, icp, dx, dy) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp
      real(c_double) :: dx, dy
    end subroutine cntc_getgriddiscretization

    subroutine cntc_getpotcontact(ire, icp, lenarr, values) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, lenarr
      real(c_double) :: values(*)
    end subroutine cntc_getpotcontact

    subroutine cntc_getpenetration(ire, icp, pen) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp
      real(c_double) :: pen
    end subroutine cntc_getpenetration

    subroutine cntc_getcreepages(ire, icp, vx, vy, phi) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp
      real(c_double) :: vx, vy, phi
    end subroutine cntc_getcreepages

    subroutine cntc_getcontactforces(ire, icp, fn, tx, ty, mz) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp
      real(c_double) :: fn, tx, ty, mz
    end subroutine cntc_getcontactforces

    subroutine cntc_getcontactpatchareas(ire, icp, carea, harea, sarea) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp
      real(c_double) :: carea, harea, sarea
    end subroutine cntc_getcontactpatchareas

    subroutine cntc_getelementdivision(ire, icp, lenarr, eldiv) bind(c)
      import :: c_int
      integer(c_int) :: ire, icp, lenarr, eldiv(*)
    end subroutine cntc_getelementdivision

    subroutine cntc_getmaximumpressure(ire, icp, pnmax) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp
      real(c_double) :: pnmax
    end subroutine cntc_getmaximumpressure

    subroutine cntc_getmaximumtraction(ire, icp, ptmax) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp
      real(c_double) :: ptmax
    end subroutine cntc_getmaximumtraction

    subroutine cntc_getmaximumtemperature(ire, icp, t1max, t2max) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp
      real(c_double) :: t1max, t2max
    end subroutine cntc_getmaximumtemperature

    subroutine cntc_getfielddata(ire, icp, ifld, lenarr, fld) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, ifld, lenarr
      real(c_double) :: fld(*)
    end subroutine cntc_getfielddata

    subroutine cntc_gettractions(ire, icp, lenarr, pn, px, py) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, lenarr
      real(c_double) :: pn(*), px(*), py(*)
    end subroutine cntc_gettractions

    subroutine cntc_getmicroslip(ire, icp, lenarr, sx, sy) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, lenarr
      real(c_double) :: sx(*), sy(*)
    end subroutine cntc_getmicroslip

    subroutine cntc_getdisplacements(ire, icp, lenarr, un, ux, uy) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, lenarr
      real(c_double) :: un(*), ux(*), uy(*)
    end subroutine cntc_getdisplacements

    subroutine cntc_getsensitivities(ire, icp, lenout, lenin, sens) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, lenout, lenin
      real(c_double) :: sens(*)
    end subroutine cntc_getsensitivities

    subroutine subs_addblock(ire, icp, iblk, isubs, nx, ny, nz, xparam, yparam, zparam) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, iblk, isubs, nx, ny, nz
      real(c_double) :: xparam(*), yparam(*), zparam(*)
    end subroutine subs_addblock

    subroutine subs_calculate(ire, icp, ierror) bind(c)
      import :: c_int
      integer(c_int) :: ire, icp, ierror
    end subroutine subs_calculate

    subroutine subs_getblocksize(ire, icp, iblk, nx, ny, nz) bind(c)
      import :: c_int
      integer(c_int) :: ire, icp, iblk, nx, ny, nz
    end subroutine subs_getblocksize

    subroutine subs_getresults(ire, icp, iblk, lenarr, ncol, icol, values) bind(c)
      import :: c_double, c_int
      integer(c_int) :: ire, icp, iblk, lenarr, ncol, icol(*)
      real(c_double) :: values(*)
    end subroutine subs_getresults
  end interface
end module contact_addon
