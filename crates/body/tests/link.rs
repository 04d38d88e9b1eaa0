//! Inertial blocks of URDF and MJCF.

use bifdiag_body::part::link::{LinkError, read_link};
use bifdiag_numbers::Number;
use bifdiag_numbers::symmetric::Symmetric;
use dashu_ratio::RBig;

fn value(text: &str) -> RBig {
    text.parse::<Number>().unwrap().value().clone()
}

const URDF: &str = r#"<robot name="r">
  <link name="base"/>
  <link name="top"><inertial>
    <origin xyz="0 0.1 0.2"/><mass value="2.5"/>
    <inertia ixx="0.3" ixy="0.01" ixz="0" iyy="0.2" iyz="-0.02" izz="0.25"/>
  </inertial></link>
  <link name="tilted"><inertial>
    <origin xyz="0 0 0" rpy="0 0 1.5707963267948966"/><mass value="1"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="2.5"/>
  </inertial></link>
</robot>"#;

#[test]
fn a_urdf_link_is_read_exactly_in_its_frame() {
    let found = read_link(URDF, Some("top")).unwrap();
    assert_eq!(found.com, ["0", "0.1", "0.2"].map(value));
    assert_eq!(found.about_com, Symmetric::new(["0.3", "0.2", "0.25", "0.01", "0", "-0.02"].map(value)));
    let turned = read_link(URDF, Some("tilted")).unwrap().about_com;
    let xx = turned.rows()[0][0].to_f64().value();
    assert!((xx - 2.0).abs() < 1e-15 && turned.determinant() == value("5"));
}

#[test]
fn an_mjcf_body_is_read_in_the_frame_of_its_quaternion() {
    let text = r#"<mujoco><worldbody><body name="b"><inertial pos="0 0 0.1" mass="2" quat="1 1 0 0"
        diaginertia="1 2 2.5"/></body></worldbody></mujoco>"#;
    let found = read_link(text, None).unwrap();
    assert_eq!(found.about_com, Symmetric::diagonal(["1", "2.5", "2"].map(value)));
    let full =
        r#"<mujoco><body name="b"><inertial pos="0 0 0" mass="1" fullinertia="1 2 2.5 0.1 0.2 0.3"/></body></mujoco>"#;
    let tensor = read_link(full, None).unwrap().about_com;
    assert_eq!(tensor, Symmetric::new(["1", "2", "2.5", "0.1", "0.2", "0.3"].map(value)));
    let euler =
        r#"<mujoco><body name="b"><inertial pos="0 0 0" mass="1" euler="90 0 0" diaginertia="1 1 1"/></body></mujoco>"#;
    assert!(matches!(read_link(euler, None), Err(LinkError::Orientation { attribute: "euler", .. })));
}

#[test]
fn files_without_the_one_block_are_refused() {
    assert!(matches!(read_link(URDF, None), Err(LinkError::Several { known, .. }) if known == ["top", "tilted"]));
    let unnamed = URDF.replace(r#" name="top""#, "").replace(r#" name="tilted""#, "");
    assert!(matches!(read_link(&unnamed, None), Err(LinkError::NoName { kind: "link" })));
    let of_one_name = URDF.replace("tilted", "top");
    assert!(matches!(read_link(&of_one_name, None), Err(LinkError::NoName { .. })));
    assert!(matches!(read_link(URDF, Some("base")), Err(LinkError::Unknown { .. })));
    assert!(matches!(read_link("<robot><link name='a'/></robot>", None), Err(LinkError::Nothing { kind: "link" })));
    assert!(matches!(read_link("<sdf/>", None), Err(LinkError::Root { .. })));
    assert!(matches!(read_link("<robot>", None), Err(LinkError::Xml(_))));
    let broken = URDF.replace("ixx=\"0.3\"", "").replace("0 0.1 0.2", "0 0.1");
    assert!(matches!(read_link(&broken, Some("top")), Err(LinkError::Missing { attribute: "ixx", .. })));
    let short = URDF.replace("0 0.1 0.2", "0 0.1");
    assert!(matches!(read_link(&short, Some("top")), Err(LinkError::Count { found: 2, wanted: 3, .. })));
    let massless = URDF.replace("value=\"2.5\"", "value=\"0\"");
    assert!(matches!(read_link(&massless, Some("top")), Err(LinkError::Mass { .. })));
}
