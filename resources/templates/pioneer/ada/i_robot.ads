--  SPDX-License-Identifier: GPL-3.0-or-later
--  A Pioneer over its ARCOS port, simulated or real: over a socket or a serial line, which differ only in the
--  configuration. A robot is passive: it has no task. The program owns its loop, and reads once per cycle:
--
--     R : Robot;
--     Begin_Comm (R, Configuration_Of ("tcp://localhost:8101"));   --  or "serial:///dev/ttyUSB0?baud=9600"
--     loop
--        Read_Data (R);                                    --  sense: waits for the state, sent each 100 ms
--        Write_Data (R, Output_Gen (Vel, 250));            --  act
--     end loop;
--
--  Any task may call anything at any time, but only one task at a time should read: the state is a protected
--  object, and a packet is written as a whole. If the program stops calling, the robot stops after two seconds.
--  Lengths are in mm, angles in degrees. Robot_Error says what is wrong; after it begin again.

with Ada.Finalization;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with GNAT.Serial_Communications;
with GNAT.Sockets;
with Interfaces;            use Interfaces;

package I_Robot is

   Robot_Error : exception;

   type Bytes is array (Natural range <>) of Unsigned_8;

   --  Commands of ARCOS; 0 to 2 are the handshake before they are PULSE, OPEN and CLOSE.
   Pulse  : constant := 0;
   Open   : constant := 1;
   Close  : constant := 2;
   Enable : constant := 4;
   Set_O  : constant := 7;
   Move   : constant := 8;
   Vel    : constant := 11;
   Head   : constant := 12;
   Dhead  : constant := 13;
   Rvel   : constant := 21;
   Sonar  : constant := 28;
   Stop   : constant := 29;
   Vel2   : constant := 32;
   E_Stop : constant := 55;

   type Link_Kind is (Socket, Serial);
   --  How a robot is reached.
   type Configuration (Kind : Link_Kind := Socket) is record
      case Kind is
         when Socket =>
            Host : Unbounded_String;
            Port : Positive := 8_101;
         when Serial =>
            Device : Unbounded_String;
            Baud   : Positive := 9_600;
      end case;
   end record;
   --  Of "tcp://HOST[:PORT]", "HOST:PORT", "serial://DEVICE[?baud=RATE]" or "/dev/...".
   function Configuration_Of (Url : String) return Configuration;

   type Robot is limited private;

   --  Opens the line and shakes hands; the motors are off afterwards. Ends a connection that there was.
   procedure Begin_Comm (R : in out Robot; Config : Configuration);
   --  Motors off, then the line is closed. A robot that goes out of scope does so by itself.
   procedure End_Comm (R : in out Robot);
   --  Waits for the next state, keeps it, and sends the PULSE that keeps the robot's watchdog quiet.
   procedure Read_Data (R : in out Robot);
   --  Sends a packet that Output_Gen has built.
   procedure Write_Data (R : in out Robot; Packet : Bytes);

   --  The whole packet of a command; a negative argument is sent as its sign and its magnitude.
   function Output_Gen (Command : Unsigned_8) return Bytes;
   function Output_Gen (Command : Unsigned_8; Argument : Integer) return Bytes;
   --  Of VEL2: the speeds of the left and of the right wheels in units of 20 mm/s.
   function Output_Gen (Command : Unsigned_8; Left, Right : Integer) return Bytes;

   --  As of the last Read_Data.
   No_Echo : constant := 5_000;
   type Ranges is array (0 .. 31) of Natural;
   function Get_Name (R : Robot) return String;
   function Get_Type (R : Robot) return String;
   --  The place by odometry, which does not wrap; the origin is where the robot was when it was connected.
   function Get_Pos_X (R : Robot) return Integer;
   function Get_Pos_Y (R : Robot) return Integer;
   function Get_Heading (R : Robot) return Float;
   function Get_Vel (R : Robot) return Integer;
   function Get_Vel_Left (R : Robot) return Integer;
   function Get_Vel_Right (R : Robot) return Integer;
   function Get_Battery (R : Robot) return Float;
   function Get_Motors (R : Robot) return Boolean;
   function Get_Stall (R : Robot) return Boolean;
   --  The distance that a sonar measured last; No_Echo if there was nothing.
   function Get_Sonar (R : Robot; Number : Natural) return Natural;
   function Get_Sonars (R : Robot) return Ranges;
   --  The nearest of some sonars.
   function Get_Nearest (R : Robot; From, To : Natural) return Natural;
   --  How many states have come since the connection began.
   function Get_States (R : Robot) return Natural;

private

   type Values is record
      X, Y             : Integer := 0;
      Last_X, Last_Y   : Integer := 0;
      Heading          : Float   := 0.0;
      Left, Right      : Integer := 0;
      Battery          : Float   := 0.0;
      Motors, Stall    : Boolean := False;
      Sonars           : Ranges  := (others => No_Echo);
      States           : Natural := 0;
      Name, Class_Type : Unbounded_String;
   end record;

   --  What is known of the robot: written by who reads, read by who decides.
   protected type State is
      procedure Start (Name, Class_Type : String);
      procedure Take (Packet : Bytes);
      function Get return Values;
   private
      Known : Values;
   end State;

   --  Held while a packet is written, so that those of several tasks do not mix.
   protected type Mutex is
      entry Seize;
      procedure Release;
   private
      Held : Boolean := False;
   end Mutex;

   type Robot is new Ada.Finalization.Limited_Controlled with record
      Connected : Boolean   := False;
      Kind      : Link_Kind := Socket;
      Line      : GNAT.Sockets.Socket_Type;
      Channel   : GNAT.Sockets.Stream_Access;
      Tty       : aliased GNAT.Serial_Communications.Serial_Port;
      Writing   : Mutex;
      Now       : State;
   end record;
   overriding procedure Finalize (R : in out Robot);

end I_Robot;
