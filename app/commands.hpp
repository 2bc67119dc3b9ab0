#pragma once

#include "app/command.hpp"

namespace microslip::app {

/// Adds `microslip batch`, which sets `exit_code` to 1 if a contact could not be solved.
void add_batch_command(Command& program, int& exit_code);

/// Adds `microslip bench`, which prints what a contact costs on this machine, and with the word `vehicle` by how much a
/// vehicle runs faster than real time, by a function that is told whether to print JSON.
void add_bench_command(Command& program, int& exit_code, int (*vehicle)(bool json));

/// Adds `microslip completion`, which prints a script that completes the program's commands and options in a shell.
void add_completion_command(Command& program);

/// Adds `microslip conicity`, which computes rolling radius difference and equivalent conicity of wheels on rails.
void add_conicity_command(Command& program);

/// Adds `microslip convert`, which writes the cases of an input file of the program CONTACT as case files and sets
/// `exit_code` to 1 unless all of them can be.
void add_convert_command(Command& program, int& exit_code);

/// microslip explore: opens the explorer's page in a browser.
void add_explore_command(Command& program);

/// Adds `microslip fit`, which fits friction and layers to measured creep curves.
void add_fit_command(Command& program);

/// Adds `microslip hertz`.
void add_hertz_command(Command& program);

/// Adds `microslip init`.
void add_init_command(Command& program);

/// Adds `microslip manual`, which prints the man page of the program, made from its commands and options.
void add_manual_command(Command& program);

/// Adds `microslip plot`, which draws the pictures of a result file.
void add_plot_command(Command& program, int& exit_code);

/// Adds `microslip profile`, which reads, checks, draws and converts the profile of a wheel or rail.
void add_profile_command(Command& program, int& exit_code);

/// Adds `microslip report`, which solves a case and writes a report of it; sets `exit_code` to 1 if the result is not
/// one.
void add_report_command(Command& program, int& exit_code);

/// Adds `microslip respond`, which computes how a contact's forces follow oscillations, over their wavelength.
void add_respond_command(Command& program, int& exit_code);

/// Adds `microslip run`, which runs the cases of an input file of the program CONTACT and sets `exit_code` to 1 unless
/// all of them are solved.
void add_run_command(Command& program, int& exit_code);

/// Adds `microslip solve`, which sets `exit_code` to 1 if the result is not one.
void add_solve_command(Command& program, int& exit_code);

/// `microslip statistics SWEEP.h5`: what the cases of a sweep say of the distribution of their quantities.
void add_statistics_command(Command& program);

/// `microslip sweep SPEC.toml -o OUT.h5`: many cases, on threads and ranks, with a checkpoint.
void add_sweep_command(Command& program, int& exit_code);

/// `microslip table`: inspects, draws and makes creep-force tables.
void add_table_command(Command& program, int& exit_code);

} // namespace microslip::app
