% The eight wheels of a vehicle in Simulink: a model with microslip_vehicle_wheels.fmu, and what one has to know of its
% ports. Not run: no Simulink was at hand. The unit is the one that the tests step by two importers.
%
%   model = simulink_wheels('microslip_vehicle_wheels.fmu');
%
% Inputs of wheel k are wheel[k].state.lateral and so on, outputs wheel[k].force_x ... wheel[k].moment_z, on the wheel,
% about its centre, in track axes: x along the track, y to the left, z up. Odd wheels are left ones. With
% wheel[k].state.vertical_force = 0 the height wheel[k].state.vertical counts, as a vehicle's model has it. The unit is
% for model exchange, in which outputs follow the inputs at once, and for co-simulation, in which they lag by a step.
function model = simulink_wheels(unit)
  model = 'microslip_wheels';
  new_system(model);
  block = [model '/wheels'];
  add_block('simulink_extras/FMU Import/FMU', block);
  set_param(block, 'FMUName', unit); % choose model exchange in the block's dialog if Simulink asks
  set_param(model, 'SolverType', 'Variable-step', 'Solver', 'ode23tb');
  % Parameters of the unit by their names, before the first step.
  set_param(block, 'track.gauge', '1.435', 'wheelset.nominal_radius', '0.46', 'friction.coefficient', '0.3');
  open_system(model);
end
