// A wheel on a rail in Modelica by microslip, with modelica_wheel.c beside it. Not run: no tool was at hand. The C side
// is called in the tests as a translated model does.
//
// One `Wheel` for each wheel, joined to the middle of its wheelset's axle, with y of frame_a along the axle to the left.
// The world's z is up, x along a straight track, and the rails' tops are at z = 0.
package MicroslipWheel
  class Contact "A wheel on a rail by its case file"
    extends ExternalObject;
    function constructor
      input String caseFile;
      output Contact contact;
      external "C" contact = microslip_modelica_create(caseFile)
        annotation (Library = {"microslip_modelica", "microslip_c"});
    end constructor;
    function destructor
      input Contact contact;
      external "C" microslip_modelica_destroy(contact) annotation (Library = {"microslip_modelica", "microslip_c"});
    end destructor;
  end Contact;

  function load "Force and moment on the wheelset about its centre, in track axes"
    input Contact contact;
    input Real motion[12] "Position of the centre, axle to the left, velocity, angular velocity; track axes, SI";
    input Real curvature "Of the track [1/m], > 0 in a curve to the left";
    output Real load[6] "[N], [N m]";
    output Integer status "0 solved, 2 not converged, 3 no contact, 6 implausible";
    external "C" status = microslip_modelica_load(contact, motion, curvature, load)
      annotation (Library = {"microslip_modelica", "microslip_c"});
    annotation (derivative(noDerivative = contact, zeroDerivative = curvature) = load_der);
  end load;

  function load_der
    input Contact contact;
    input Real motion[12];
    input Real curvature;
    input Real motion_der[12];
    output Real load_der[6];
    external "C" microslip_modelica_load_der(contact, motion, curvature, motion_der, load_der)
      annotation (Library = {"microslip_modelica", "microslip_c"});
  end load_der;

  model Wheel "Load of one wheel on the middle of its wheelset's axle"
    parameter String caseFile = "wheel_1.toml";
    parameter Real curvature = 0;
    Modelica.Mechanics.MultiBody.Interfaces.Frame_a frame_a;
    Contact contact = Contact(caseFile);
    Real motion[12], wheelLoad[6];
    Integer status;
  equation
    motion[1:3] = frame_a.r_0;
    motion[4:6] = Modelica.Mechanics.MultiBody.Frames.resolve1(frame_a.R, {0, 1, 0});
    motion[7:9] = der(frame_a.r_0);
    motion[10:12] = Modelica.Mechanics.MultiBody.Frames.angularVelocity1(frame_a.R);
    (wheelLoad, status) = load(contact, motion, curvature);
    // A connector's force acts on this model: the wheelset gets the opposite.
    frame_a.f = -Modelica.Mechanics.MultiBody.Frames.resolve2(frame_a.R, wheelLoad[1:3]);
    frame_a.t = -Modelica.Mechanics.MultiBody.Frames.resolve2(frame_a.R, wheelLoad[4:6]);
  end Wheel;
end MicroslipWheel;
