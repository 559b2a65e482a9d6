# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of welds and bolts in every format."""

from __future__ import annotations

XMCF = b"""<?xml version="1.0" encoding="iso-8859-1"?>
<xmcf xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">
  <version>3.0.1</version> <!-- > not here: <loc>1 2 3</loc> -->
  <units length="mm" angle="rad" mass="kg" force="N" time="s"/>
  <connection_group id="1">
    <connected_to><part index="1" label="1"/><part index="2" pid="2"/></connected_to>
    <connection_list>
      <connection_0d label="bolt &amp; nut">
        <threaded_connection diameter="5" length="4">
          <normal_direction x='0' y="0.0" z = "2"/>
          <bolt><nut diameter="8."/></bolt>
        </threaded_connection>
        <loc> 85.0 15.5 1.0 </loc>
        <appdata>caf\xe9</appdata>
      </connection_0d>
      <connection_1d label="glue">
        <loc_list><loc v="0">72. 12.5 1</loc>\t<loc v="1">88,12.5,1.0</loc></loc_list>
        <adhesive_line/>
      </connection_1d>
    </connection_list>
  </connection_group>
</xmcf>
"""
MCF = b"""<xml_connection_file><version> 1.0.0 </version><connection_group><id> 1 </id>
<connected_to> <pid> 1 </pid> <pid> 2 </pid> </connected_to>
<connection_list><connection_0d> <id> 100001 </id> <type>spotweld</type>
<loc> 85 1.55E1 1.94 </loc> <info> dia 5. </info></connection_0d></connection_list>
</connection_group></xml_connection_file>\r\n"""
VIP = (
    b"$ welds\r\nWSPOT,1,5.0,85.0,15.5,1.0,1,2,\r\nMASTIC,7,1.,2.,3.,1,2\r\n"
    b"WSPOT 2 5.0 75 22.5 1 deck/1 deck/2"
)
CSV = (
    b'\xef\xbb\xbfid;"x [cm]";y [cm];z [cm];part 1;part 2;note\n# none\n'
    b'A1;8,5;1,55;0,1;1;2;"a ""b"";c"\n\nA2;"7,5";2,25;0,1;2;1\n'
)


def joint_samples() -> dict[str, bytes]:
    """By file name."""
    return {"bolts.xmcf": XMCF, "spots.mcf": MCF, "spots.vip": VIP, "spots.csv": CSV}
