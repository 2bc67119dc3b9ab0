// What inputs mean to who is new to rolling contact, beside the text, unit and range that the library says of them.

/** By the keys of case files. */
export const inWords: Record<string, string> = {
  "wheel.lateral": "How far the wheelset's middle is from the middle of the track. On straight track it sways some 3 mm; a few millimetres further the flange touches.",
  "wheel.yaw": "How far the axle is turned about the vertical, seen from above. 1 mrad is 1 mm per metre. A turned wheel rubs sideways.",
  "wheel.vertical_force": "What this wheel presses on its rail. A loaded freight wagon: 110 kN a wheel; a passenger coach: 60 kN.",
  "wheel.forward_velocity": "How fast it rolls. It changes heat, not forces, as long as friction does not depend on speed.",
  "friction.coefficient": "Largest friction per load. Dry 0.3 to 0.5, wet 0.1 to 0.25, leaves or ice below 0.1.",
  "track.cant": "Rails stand tilted towards each other: 1:40 in Germany, 1:20 in France and Britain. It moves the contact and changes steering. Takes slopes as 1:40.",
  "track.gauge": "The distance of the inner sides of both rails: 1435 mm on most tracks of the world.",
  "track.curvature": "How strongly the track bends: one over the radius, positive to the left. Takes radii as R 300 m.",
  "wheelset.nominal_radius": "The wheel's radius where it runs on straight track.",
  "load.normal_force": "What presses the bodies together. A loaded freight wheel: 110 kN; a car's wheel: 4 kN.",
  "motion.creepage_longitudinal": "By how much the wheel turns slower than it rolls: 0.12 % is 1.2 mm per metre. Stretching takes up a little of it, the rest is sliding. Negative: driving.",
  "motion.creepage_lateral": "By how much the wheel moves sideways over the rail, per distance rolled; a yaw of 1 mrad makes about 0.1 %.",
  "motion.spin": "How much the wheel turns about the middle of the contact, per metre rolled, as a coin that rolls in a circle; it comes from the slope of the tread.",
  "motion.rolling_speed": "How fast it rolls. It changes heat, not forces, as long as friction does not depend on speed.",
};
