// c990cd15221f2800 names what this was made from: unity_link_fifo in its configuration 'minimal', by GHDL and Yosys 0.70.0.
// Made by `make rtl`: change the VHDL in gateware/rtl instead.

#include <cxxrtl/cxxrtl.h>

#if defined(CXXRTL_INCLUDE_CAPI_IMPL) || \
    defined(CXXRTL_INCLUDE_VCD_CAPI_IMPL)
#include <cxxrtl/capi/cxxrtl_capi.cc>
#endif

#if defined(CXXRTL_INCLUDE_VCD_CAPI_IMPL)
#include <cxxrtl/capi/cxxrtl_capi_vcd.cc>
#endif

using namespace cxxrtl_yosys;

namespace cxxrtl_design {

// \top: 1
// \src: top.v:9680.1-9773.10
struct p_unity__link__fifo : public module {
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4744_q
	// \src: top.v:1296.14-1296.21
	wire<93> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2133_q
	// \src: top.v:6311.15-6311.22
	wire<118> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3496_o
	// \src: top.v:2774.8-2774.15
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3496__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3631_q
	// \src: top.v:2844.13-2844.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3631__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3629_q
	// \src: top.v:2842.14-2842.21
	wire<11> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3629__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3628_q
	// \src: top.v:2841.7-2841.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3628__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3626_q
	// \src: top.v:2839.7-2839.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3626__q;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3623_q
	// \src: top.v:2836.13-2836.20
	wire<2> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3623__q;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n920_q
	// \src: top.v:7945.14-7945.20
	wire<54> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3341_q
	// \src: top.v:4022.14-4022.21
	wire<75> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst out_ready
	// \src: top.v:208.11-208.20
	wire<1> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_out__ready;
	// \hdlname: unity_link_inst core_inst request_executor_inst ring_room
	// \src: top.v:3294.17-3294.26
	wire<2> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n5162_data
	// \src: top.v:66.13-66.23
	wire<10> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5162__data;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n5161_q
	// \src: top.v:65.7-65.14
	wire<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5161__q;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n5154_q
	// \src: top.v:60.13-60.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5154__q;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n5153_q
	// \src: top.v:59.13-59.20
	wire<8> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5153__q;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst bypass
	// \src: top.v:19.14-19.20
	wire<10> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst count
	// \src: top.v:8590.14-8590.19
	wire<9> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst bypass
	// \src: top.v:8596.14-8596.20
	wire<9> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n328_q
	// \src: top.v:8636.13-8636.19
	wire<8> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n328__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n329_q
	// \src: top.v:8637.13-8637.19
	wire<8> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n329__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n336_q
	// \src: top.v:8642.7-8642.13
	wire<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n336__q;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n337_data
	// \src: top.v:8643.13-8643.22
	wire<9> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n337__data;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst count
	// \src: top.v:13.14-13.19
	wire<9> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count;
	// \hdlname: unity_link_inst core_inst frame_writer_inst response_word
	// \src: top.v:793.17-793.30
	wire<8> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word;
	// \hdlname: unity_link_inst core_inst request_executor_inst memory_kept
	// \src: top.v:3337.14-3337.25
	wire<8> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept;
	// \hdlname: unity_link_inst core_inst access_failure
	// \src: top.v:8937.14-8937.28
	wire<4> p_unity__link__inst_2e_core__inst_2e_access__failure;
	// \hdlname: unity_link_inst core_inst response_ring_inst committed
	// \src: top.v:3183.14-3183.23
	wire<2> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed;
	// \hdlname: unity_link_inst core_inst memory_word
	// \src: top.v:8919.14-8919.25
	wire<8> p_unity__link__inst_2e_core__inst_2e_memory__word;
	// \hdlname: unity_link_inst core_inst response_ring_inst n3416_q
	// \src: top.v:3202.13-3202.20
	wire<2> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3416__q;
	// \hdlname: unity_link_inst core_inst response_ring_inst n3418_q
	// \src: top.v:3204.13-3204.20
	wire<2> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3418__q;
	// \hdlname: unity_link_inst core_inst character_valid
	// \src: top.v:8892.8-8892.23
	wire<1> p_unity__link__inst_2e_core__inst_2e_character__valid;
	// \hdlname: unity_link_inst core_inst character_in
	// \src: top.v:8891.14-8891.26
	wire<9> p_unity__link__inst_2e_core__inst_2e_character__in;
	// \hdlname: unity_link_inst core_inst fifo_out_valid
	// \src: top.v:8889.8-8889.22
	wire<1> p_unity__link__inst_2e_core__inst_2e_fifo__out__valid;
	// \hdlname: unity_link_inst core_inst bus_master_inst for_sample
	// \src: top.v:2741.8-2741.18
	wire<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n5058_q
	// \src: top.v:380.14-380.21
	wire<26> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q;
	// \src: top.v:9701.17-9701.25
	/*output*/ wire<8> p_wb__dat__o;
	// \src: top.v:9700.17-9700.23
	/*output*/ wire<8> p_wb__adr;
	// \src: top.v:9699.11-9699.17
	/*output*/ value<1> p_wb__sel;
	// \src: top.v:9698.11-9698.16
	/*output*/ wire<1> p_wb__we;
	// \src: top.v:9697.11-9697.17
	/*output*/ wire<1> p_wb__stb;
	// \src: top.v:9696.11-9696.17
	/*output*/ value<1> p_wb__cyc;
	// \src: top.v:9695.11-9695.20
	/*output*/ value<1> p_out__flush;
	// \src: top.v:9694.11-9694.20
	/*output*/ wire<1> p_out__valid;
	// \src: top.v:9693.17-9693.25
	/*output*/ value<8> p_out__data;
	// \src: top.v:9692.11-9692.19
	/*output*/ wire<1> p_in__ready;
	// \src: top.v:9691.11-9691.19
	/*input*/ value<1> p_wb__stall;
	// \src: top.v:9690.11-9690.17
	/*input*/ value<1> p_wb__err;
	// \src: top.v:9689.11-9689.17
	/*input*/ value<1> p_wb__ack;
	// \src: top.v:9688.17-9688.25
	/*input*/ value<8> p_wb__dat__i;
	// \src: top.v:9687.11-9687.18
	/*input*/ value<1> p_trigger;
	// \src: top.v:9686.11-9686.20
	/*input*/ value<1> p_out__ready;
	// \src: top.v:9685.11-9685.19
	/*input*/ value<1> p_in__valid;
	// \src: top.v:9684.11-9684.18
	/*input*/ value<1> p_in__lost;
	// \src: top.v:9683.17-9683.24
	/*input*/ value<8> p_in__data;
	// \src: top.v:9682.11-9682.14
	/*input*/ value<1> p_rst;
	// \src: top.v:9681.11-9681.14
	/*input*/ value<1> p_clk;
	value<1> prev_p_clk;
	bool posedge_p_clk() const {
		return !prev_p_clk.slice<0>().val() && p_clk.slice<0>().val();
	}
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4745
	// \src: top.v:2433.13-2433.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4745 { 64u };
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4747
	// \src: top.v:2503.13-2503.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747 { 64u };
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4749
	// \src: top.v:2573.13-2573.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4749 { 64u };
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4751
	// \src: top.v:2643.13-2643.18
	memory<4> memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4751 { 64u };
	// \hdlname: unity_link_inst core_inst response_ring_inst memory
	// \src: top.v:3267.13-3267.19
	memory<8> memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory { 2u };
	// \hdlname: unity_link_inst core_inst rx_fifo_inst memory
	// \no_rw_check: 1
	// \src: top.v:8766.36-8766.42
	memory<9> memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory { 256u };
	// \hdlname: unity_link_inst core_inst tx_fifo_inst memory
	// \no_rw_check: 1
	// \src: top.v:189.36-189.42
	memory<10> memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory { 256u };
	// \hdlname: unity_link_inst core_inst request_memory_inst memory
	// \src: top.v:5689.13-5689.19
	memory<8> memory_p_unity__link__inst_2e_core__inst_2e_request__memory__inst_2e_memory { 2u };

	p_unity__link__fifo(interior) {}
	p_unity__link__fifo() {
		reset();
	};

	void reset() override;

	bool eval(performer *performer = nullptr) override;

	template<class ObserverT>
	bool commit(ObserverT &observer) {
		bool changed = false;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3496__o.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3631__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3629__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3628__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3626__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3623__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_out__ready.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5162__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5161__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5154__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5153__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n328__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n329__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n336__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n337__data.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_access__failure.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_memory__word.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3416__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3418__q.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_character__valid.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_character__in.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.commit(observer)) changed = true;
		if (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.commit(observer)) changed = true;
		if (p_wb__dat__o.commit(observer)) changed = true;
		if (p_wb__adr.commit(observer)) changed = true;
		if (p_wb__we.commit(observer)) changed = true;
		if (p_wb__stb.commit(observer)) changed = true;
		if (p_out__valid.commit(observer)) changed = true;
		if (p_in__ready.commit(observer)) changed = true;
		prev_p_clk = p_clk;
		if (memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory.commit(observer)) changed = true;
		if (memory_p_unity__link__inst_2e_core__inst_2e_request__memory__inst_2e_memory.commit(observer)) changed = true;
		return changed;
	}

	bool commit() override {
		observer observer;
		return commit<>(observer);
	}
}; // struct p_unity__link__fifo

void p_unity__link__fifo::reset() {
	static const value<4> mem_init_1[64] {
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0xau},
		value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x8u}, value<4>{0x6u}, value<4>{0x9u},
		value<4>{0x8u}, value<4>{0x9u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x1u}, value<4>{0x0u}, value<4>{0x7u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x2u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x8u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_1), std::end(mem_init_1), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4745.data[0]);
	static const value<4> mem_init_2[64] {
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0xau},
		value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x8u}, value<4>{0x6u}, value<4>{0x9u},
		value<4>{0x8u}, value<4>{0x9u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x1u}, value<4>{0x0u}, value<4>{0x7u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x2u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x8u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_2), std::end(mem_init_2), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747.data[0]);
	static const value<4> mem_init_3[64] {
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0xau},
		value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x8u}, value<4>{0x6u}, value<4>{0x9u},
		value<4>{0x8u}, value<4>{0x9u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x1u}, value<4>{0x0u}, value<4>{0x7u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x2u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x8u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_3), std::end(mem_init_3), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4749.data[0]);
	static const value<4> mem_init_4[64] {
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x2u}, value<4>{0x1u}, value<4>{0xau},
		value<4>{0x7u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x8u}, value<4>{0x6u}, value<4>{0x9u},
		value<4>{0x8u}, value<4>{0x9u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x2u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x1u}, value<4>{0x0u}, value<4>{0x7u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u}, value<4>{0x0u},
		value<4>{0x0u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x2u}, value<4>{0x0u}, value<4>{0x8u}, value<4>{0x0u},
		value<4>{0x8u}, value<4>{0x0u}, value<4>{0x1u}, value<4>{0x0u},
	};
	std::copy(std::begin(mem_init_4), std::end(mem_init_4), &memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4751.data[0]);
}

bool p_unity__link__fifo::eval(performer *performer) {
	bool converged = true;
	bool posedge_p_clk = this->posedge_p_clk();
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2708__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2690__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3947_o
	// \src: top.v:955.8-955.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3947__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2689__CMP;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4877_o
	// \src: top.v:274.14-274.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4877__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2685__CMP;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4870_o
	// \src: top.v:269.14-269.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4870__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1783_o
	// \src: top.v:6131.8-6131.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1783__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1786_o
	// \src: top.v:6133.8-6133.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1786__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4863_o
	// \src: top.v:264.14-264.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4863__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1792_o
	// \src: top.v:6137.8-6137.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1792__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1793_o
	// \src: top.v:6138.8-6138.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1793__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1796_o
	// \src: top.v:6140.8-6140.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1796__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4856_o
	// \src: top.v:259.14-259.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4856__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4518_o
	// \src: top.v:1173.13-1173.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4518__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4915_o
	// \src: top.v:294.14-294.21
	value<8> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4915__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4901_o
	// \src: top.v:292.8-292.15
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4901__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4896_o
	// \src: top.v:288.15-288.22
	value<13> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4896__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4849_o
	// \src: top.v:254.14-254.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4849__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2387__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2404__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2650__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2411__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2417__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2422__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2426__CMP;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4842_o
	// \src: top.v:249.14-249.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4842__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2429__CMP;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3337;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3341;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3347;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2441__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1846_o
	// \src: top.v:6168.8-6168.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1846__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2442__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2443__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2444__CMP;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3353;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3355;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2453__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2454__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2455__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2456__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2465__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2466__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2467__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2468__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4583_o
	// \src: top.v:1206.8-1206.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4583__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2477__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2478__CMP;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4835_o
	// \src: top.v:244.14-244.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4835__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2485__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2486__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2487__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2488__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2489__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2490__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1884_o
	// \src: top.v:6182.8-6182.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1884__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1062_o
	// \src: top.v:5786.8-5786.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1062__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4622_o
	// \src: top.v:1223.13-1223.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4622__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1396_o
	// \src: top.v:5925.14-5925.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1396__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1890_o
	// \src: top.v:6186.8-6186.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1890__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst left
	// \src: top.v:5735.14-5735.18
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1896_o
	// \src: top.v:6190.8-6190.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1896__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst advance
	// \src: top.v:7628.8-7628.15
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_advance;
	// \hdlname: unity_link_inst core_inst request_decoder_inst field
	// \src: top.v:5734.14-5734.19
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1401_o
	// \src: top.v:5928.8-5928.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst digit
	// \src: top.v:5733.8-5733.13
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit;
	// \hdlname: unity_link_inst core_inst request_decoder_inst letter
	// \src: top.v:5732.8-5732.14
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1405_o
	// \src: top.v:5931.8-5931.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n390_o
	// \src: top.v:7646.8-7646.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n390__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1059_o
	// \src: top.v:5784.14-5784.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1937_o
	// \src: top.v:6212.8-6212.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1937__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1943_o
	// \src: top.v:6213.8-6213.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1943__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n439_o
	// \src: top.v:7661.14-7661.20
	value<8> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n439__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1951_o
	// \src: top.v:6215.8-6215.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1951__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1411_o
	// \src: top.v:5935.8-5935.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1411__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1412_o
	// \src: top.v:5936.8-5936.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1054_o
	// \src: top.v:5783.14-5783.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4951_o
	// \src: top.v:319.14-319.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4951__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4958_o
	// \src: top.v:324.14-324.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4958__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1962_o
	// \src: top.v:6224.8-6224.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1962__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1416_o
	// \src: top.v:5939.8-5939.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1049_o
	// \src: top.v:5780.8-5780.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1420_o
	// \src: top.v:5942.8-5942.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n498_o
	// \src: top.v:7703.14-7703.20
	value<8> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n498__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n499_o
	// \src: top.v:7704.8-7704.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n499__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4746_data
	// \src: top.v:1297.14-1297.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4746__data;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4748_data
	// \src: top.v:1298.14-1298.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4748__data;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4750_data
	// \src: top.v:1299.14-1299.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4750__data;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4752_data
	// \src: top.v:1300.14-1300.24
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4752__data;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4965_o
	// \src: top.v:329.14-329.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4965__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1424_o
	// \src: top.v:5945.8-5945.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2505_o
	// \src: top.v:3490.8-3490.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2505__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2929__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1995_o
	// \src: top.v:6242.8-6242.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1995__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1149_o
	// \src: top.v:5822.8-5822.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1149__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3065__CMP;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n530_o
	// \src: top.v:7733.8-7733.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n530__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n539_o
	// \src: top.v:7735.8-7735.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n539__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n540_o
	// \src: top.v:7736.8-7736.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n540__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3064__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3063__CMP;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n554_o
	// \src: top.v:7745.8-7745.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n554__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3835_o
	// \src: top.v:913.15-913.22
	value<22> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3835__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2525_o
	// \src: top.v:3494.8-3494.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2525__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n607_o
	// \src: top.v:7756.8-7756.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n607__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2661_o
	// \src: top.v:3570.13-3570.20
	value<3> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2661__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n627_o
	// \src: top.v:7765.8-7765.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n627__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1435_o
	// \src: top.v:5954.8-5954.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1437_o
	// \src: top.v:5955.8-5955.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1437__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2667_o
	// \src: top.v:3576.13-3576.20
	value<2> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2667__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1438_o
	// \src: top.v:5956.8-5956.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1026_o
	// \src: top.v:5772.8-5772.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n673_o
	// \src: top.v:7784.8-7784.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n673__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n693_o
	// \src: top.v:7793.8-7793.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n693__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1152_o
	// \src: top.v:5825.8-5825.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1152__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4944_o
	// \src: top.v:314.14-314.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4944__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2680_o
	// \src: top.v:3589.8-3589.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2680__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2682_o
	// \src: top.v:3591.14-3591.21
	value<3> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2682__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2683_o
	// \src: top.v:3592.14-3592.21
	value<4> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2683__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4937_o
	// \src: top.v:309.14-309.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4937__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2687_o
	// \src: top.v:3595.14-3595.21
	value<8> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2687__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4001_o
	// \src: top.v:970.8-970.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4001__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2054_o
	// \src: top.v:6274.14-6274.21
	value<10> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2054__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2551_o
	// \src: top.v:3507.8-3507.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2551__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2928__CMP;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n759_o
	// \src: top.v:7832.15-7832.21
	value<22> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n759__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3842_o
	// \src: top.v:920.14-920.21
	value<2> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3842__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n762_o
	// \src: top.v:7835.14-7835.20
	value<8> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n762__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n770_o
	// \src: top.v:7840.8-7840.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n770__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1014_o
	// \src: top.v:5767.8-5767.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1014__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2074_o
	// \src: top.v:6294.16-6294.23
	value<118> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2074__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2934__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n2076_o
	// \src: top.v:6296.8-6296.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2076__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2933__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2932__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1470_o
	// \src: top.v:5982.15-5982.22
	value<11> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1470__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3479_o
	// \src: top.v:2766.8-2766.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3479__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1474_o
	// \src: top.v:5984.8-5984.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1474__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst failed
	// \src: top.v:3336.8-3336.14
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n994_o
	// \src: top.v:5758.8-5758.14
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n994__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n864_o
	// \src: top.v:7897.15-7897.21
	value<26> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n864__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n867_o
	// \src: top.v:7900.14-7900.20
	value<9> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n867__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n870_o
	// \src: top.v:7902.8-7902.14
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n870__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4013_o
	// \src: top.v:974.8-974.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4013__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3857_o
	// \src: top.v:925.8-925.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3857__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2931__CMP;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3541_o
	// \src: top.v:2801.8-2801.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3541__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3539_o
	// \src: top.v:2800.8-2800.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3539__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3861_o
	// \src: top.v:926.8-926.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3861__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4814_o
	// \src: top.v:237.13-237.20
	value<7> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4814__o_5b_6_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4827_o
	// \src: top.v:239.14-239.21
	value<8> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4827__o;
	// \src: top.v:193.3-195.35
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_195_24_1__EN_5b_9_3a_0_5d__24_52_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4810_o
	// \src: top.v:235.8-235.15
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4810__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1244_o
	// \src: top.v:5876.8-5876.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1244__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1247_o
	// \src: top.v:5877.8-5877.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1247__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2527__CMP;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4764_o
	// \src: top.v:220.8-220.15
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4764__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst advance
	// \src: top.v:215.8-215.15
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_advance;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2526__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2525__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2524__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2523__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3751_o
	// \src: top.v:873.8-873.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3751__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP;
	// \src: top.v:192.21-192.27
	value<10> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_192_24_48__DATA;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3738_o
	// \src: top.v:868.8-868.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3738__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2521__CMP;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3734_o
	// \src: top.v:865.8-865.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3734__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2520__CMP;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3263_o
	// \src: top.v:3974.8-3974.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3263__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3728_o
	// \src: top.v:860.8-860.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3728__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3258_o
	// \src: top.v:3971.8-3971.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3258__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4031_o
	// \src: top.v:978.8-978.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4031__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3712_o
	// \src: top.v:853.8-853.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4040_o
	// \src: top.v:980.8-980.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4040__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3709_o
	// \src: top.v:851.8-851.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3709__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3237_o
	// \src: top.v:3957.8-3957.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3237__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1516_o
	// \src: top.v:5999.8-5999.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1516__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3232_o
	// \src: top.v:3955.8-3955.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3232__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst last_word
	// \src: top.v:3334.8-3334.17
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3227_o
	// \src: top.v:3952.8-3952.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3227__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4049_o
	// \src: top.v:982.8-982.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4049__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1518_o
	// \src: top.v:6000.8-6000.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1518__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4058_o
	// \src: top.v:984.8-984.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4058__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1519_o
	// \src: top.v:6001.8-6001.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1522_o
	// \src: top.v:6002.8-6002.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1522__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4071_o
	// \src: top.v:988.14-988.21
	value<5> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4071__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4073_o
	// \src: top.v:989.8-989.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4073__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n5114_o
	// \src: top.v:42.8-42.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5114__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n5106_o
	// \src: top.v:37.8-37.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5106__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n5099_o
	// \src: top.v:32.8-32.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5099__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n5096_o
	// \src: top.v:29.8-29.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5096__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4080_o
	// \src: top.v:991.8-991.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4080__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4085_o
	// \src: top.v:993.8-993.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4085__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2863__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1548_o
	// \src: top.v:6010.8-6010.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n5066_o
	// \src: top.v:22.8-22.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5066__o;
	// \hdlname: unity_link_inst core_inst tx_fifo_inst n5065_o
	// \src: top.v:21.8-21.15
	value<1> p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5065__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4106_o
	// \src: top.v:1000.8-1000.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4106__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4110_o
	// \src: top.v:1001.14-1001.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4110__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3520_o
	// \src: top.v:2790.8-2790.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3520__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3651_o
	// \src: top.v:817.8-817.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3651__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4930_o
	// \src: top.v:304.14-304.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4930__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4112_o
	// \src: top.v:1003.14-1003.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4112__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3832_o
	// \src: top.v:910.14-910.21
	value<9> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3832__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3157_o
	// \src: top.v:3900.14-3900.21
	value<8> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3157__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4114_o
	// \src: top.v:1005.8-1005.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4114__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n240_o
	// \src: top.v:8598.8-8598.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n240__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n241_o
	// \src: top.v:8599.8-8599.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n241__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n271_o
	// \src: top.v:8606.8-8606.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n271__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n274_o
	// \src: top.v:8609.8-8609.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n274__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n281_o
	// \src: top.v:8614.8-8614.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n281__o;
	// \hdlname: unity_link_inst core_inst rx_fifo_inst n289_o
	// \src: top.v:8619.8-8619.14
	value<1> p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n289__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3152_o
	// \src: top.v:3896.8-3896.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3152__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3148_o
	// \src: top.v:3895.8-3895.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3148__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3886_o
	// \src: top.v:934.8-934.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3886__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst load_word
	// \src: top.v:810.8-810.17
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3137_o
	// \src: top.v:3888.14-3888.21
	value<5> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3137__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst advance
	// \src: top.v:807.8-807.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3135_o
	// \src: top.v:3886.14-3886.21
	value<5> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3135__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3134_o
	// \src: top.v:3885.15-3885.22
	value<31> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3134__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3132_o
	// \src: top.v:3883.15-3883.22
	value<14> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3132__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4121_o
	// \src: top.v:1012.14-1012.21
	value<3> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4121__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4122_o
	// \src: top.v:1013.14-1013.21
	value<6> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4122__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4123_o
	// \src: top.v:1014.8-1014.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4123__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4129_o
	// \src: top.v:1019.8-1019.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4129__o;
	// \src: top.v:5690.3-5692.40
	value<8> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2155__data_5b_7_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3105_o
	// \src: top.v:3856.15-3856.22
	value<14> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3105__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3889_o
	// \src: top.v:936.8-936.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3889__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3890_o
	// \src: top.v:937.8-937.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3890__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1250_o
	// \src: top.v:5878.8-5878.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1250__o;
	// \hdlname: unity_link_inst bus_done
	// \src: top.v:9529.8-9529.16
	value<1> p_unity__link__inst_2e_bus__done;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1576_o
	// \src: top.v:6019.8-6019.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1576__o;
	// \src: top.v:8769.20-8769.26
	value<9> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_8769_24_2313__DATA;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1253_o
	// \src: top.v:5879.8-5879.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1593_o
	// \src: top.v:6021.13-6021.20
	value<4> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1593__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1256_o
	// \src: top.v:5880.8-5880.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1260_o
	// \src: top.v:5881.8-5881.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1260__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1262_o
	// \src: top.v:5882.8-5882.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1262__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2864__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2304_o
	// \src: top.v:3390.8-3390.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2304__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3059_o
	// \src: top.v:3813.14-3813.21
	value<11> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3059__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2297_o
	// \src: top.v:3389.8-3389.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2297__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2293_o
	// \src: top.v:3387.8-3387.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2293__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3049_o
	// \src: top.v:3805.8-3805.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3049__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3040_o
	// \src: top.v:3802.8-3802.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3040__o;
	// \hdlname: unity_link_inst core_inst bus_master_inst n3457_o
	// \src: top.v:2760.8-2760.15
	value<1> p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3457__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1282_o
	// \src: top.v:5886.8-5886.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1282__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1285_o
	// \src: top.v:5887.8-5887.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1285__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1161_o
	// \src: top.v:5834.8-5834.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1161__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3029_o
	// \src: top.v:3793.15-3793.22
	value<14> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3029__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1635_o
	// \src: top.v:6040.14-6040.21
	value<9> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1635__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3901_o
	// \src: top.v:940.8-940.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3901__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2260_o
	// \src: top.v:3368.8-3368.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2260__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2350_o
	// \src: top.v:3409.8-3409.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2350__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n3006_o
	// \src: top.v:3771.15-3771.22
	value<14> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3006__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3904_o
	// \src: top.v:942.8-942.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3904__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1301_o
	// \src: top.v:5892.8-5892.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1301__o;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3117__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3116__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3115__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3114__CMP;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3113__CMP;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1307_o
	// \src: top.v:5894.8-5894.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1307__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2207_o
	// \src: top.v:3348.8-3348.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2207__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2195_o
	// \src: top.v:3344.8-3344.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2195__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2192_o
	// \src: top.v:3342.8-3342.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2192__o;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3315;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3317;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4291_o
	// \src: top.v:1074.8-1074.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4291__o;
	value<1> i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3329;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1331_o
	// \src: top.v:5900.8-5900.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1331__o;
	// \hdlname: unity_link_inst core_inst answer_has_id
	// \src: top.v:8949.8-8949.21
	value<1> p_unity__link__inst_2e_core__inst_2e_answer__has__id;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1337_o
	// \src: top.v:5902.8-5902.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1337__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4319_o
	// \src: top.v:1081.8-1081.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4319__o;
	// \hdlname: unity_link_inst core_inst answer_taken
	// \src: top.v:8944.8-8944.20
	value<1> p_unity__link__inst_2e_core__inst_2e_answer__taken;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3910_o
	// \src: top.v:946.8-946.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3910__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4322_o
	// \src: top.v:1084.13-1084.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4322__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1671_o
	// \src: top.v:6074.15-6074.22
	value<93> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2376_o
	// \src: top.v:3424.8-3424.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2376__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3911_o
	// \src: top.v:947.8-947.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3911__o;
	// \hdlname: unity_link_inst core_inst access_done
	// \src: top.v:8933.8-8933.19
	value<1> p_unity__link__inst_2e_core__inst_2e_access__done;
	// \hdlname: unity_link_inst core_inst access_granted
	// \src: top.v:8932.8-8932.22
	value<1> p_unity__link__inst_2e_core__inst_2e_access__granted;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1674_o
	// \src: top.v:6077.8-6077.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o;
	// \hdlname: unity_link_inst core_inst access_exclusive
	// \src: top.v:8929.8-8929.24
	value<1> p_unity__link__inst_2e_core__inst_2e_access__exclusive;
	// \hdlname: unity_link_inst core_inst response_ring_inst n3383_o
	// \src: top.v:3189.14-3189.21
	value<2> p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3383__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst is_queue
	// \src: top.v:3331.8-3331.16
	value<1> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1340_o
	// \src: top.v:5903.8-5903.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1340__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1683_o
	// \src: top.v:6083.8-6083.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1683__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1343_o
	// \src: top.v:5904.8-5904.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1343__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1687_o
	// \src: top.v:6086.8-6086.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1687__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1690_o
	// \src: top.v:6088.8-6088.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1690__o;
	// \hdlname: unity_link_inst core_inst fifo_out_ready
	// \src: top.v:8890.8-8890.22
	value<1> p_unity__link__inst_2e_core__inst_2e_fifo__out__ready;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1691_o
	// \src: top.v:6089.8-6089.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4362_o
	// \src: top.v:1105.14-1105.21
	value<6> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4362__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1692_o
	// \src: top.v:6090.8-6090.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1692__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3920_o
	// \src: top.v:949.8-949.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3920__o;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1359_o
	// \src: top.v:5908.8-5908.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1359__o;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3929_o
	// \src: top.v:951.8-951.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3929__o;
	// \src: top.v:3268.3-3270.37
	value<8> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3423__data_5b_7_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n489_o
	// \src: top.v:7696.14-7696.20
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n489__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n482_o
	// \src: top.v:7691.14-7691.20
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n482__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n475_o
	// \src: top.v:7686.14-7686.20
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n475__o_5b_2_3a_0_5d_;
	// \src: top.v:8770.3-8772.35
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_8772_24_2266__EN_5b_8_3a_0_5d__24_2317_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n468_o
	// \src: top.v:7681.14-7681.20
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n468__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n461_o
	// \src: top.v:7676.14-7676.20
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n461__o_5b_2_3a_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2725__CMP;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n454_o
	// \src: top.v:7671.14-7671.20
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n454__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n5029_o
	// \src: top.v:362.8-362.15
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5029__o;
	// \hdlname: unity_link_inst core_inst datalink_rx_inst n447_o
	// \src: top.v:7666.14-7666.20
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n447__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n5020_o
	// \src: top.v:360.8-360.15
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5020__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n5015_o
	// \src: top.v:359.8-359.15
	value<1> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5015__o;
	// \src: top.v:5693.3-5695.41
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_5695_24_1764__EN_5b_7_3a_0_5d__24_1770_5b_0_5d_;
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2722__CMP;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2546_o
	// \src: top.v:3503.14-3503.21
	value<2> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2546__o_5b_1_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n3938_o
	// \src: top.v:953.8-953.15
	value<1> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3938__o;
	// \hdlname: unity_link_inst core_inst request_executor_inst n2522_o
	// \src: top.v:3493.14-3493.21
	value<3> p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2522__o_5b_2_3a_0_5d_;
	// \src: top.v:3271.3-3273.37
	value<1> i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_3273_24_1293__EN_5b_7_3a_0_5d__24_1319_5b_0_5d_;
	// \hdlname: unity_link_inst core_inst frame_writer_inst n4425_o
	// \src: top.v:1131.13-1131.20
	value<4> p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4425__o;
	// \hdlname: unity_link_inst core_inst datalink_tx_inst n4923_o
	// \src: top.v:299.14-299.21
	value<3> p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4923__o_5b_2_3a_0_5d_;
	// \hdlname: unity_link_inst core_inst request_decoder_inst n1749_o
	// \src: top.v:6112.8-6112.15
	value<1> p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1749__o;
	// \src: top.v:8020.19-8020.34
	// cell $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$xor$top.v:8020$2134
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n439__o = xor_uu<8>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<25,18>().val(), p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<7,0>().val());
	// \src: top.v:673.20-673.36
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$eq$top.v:673$119
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4810__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<4,3>().val(), value<1>{0x1u});
	// \src: top.v:4505.20-4505.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4505$1485
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<3,0>().val(), value<4>{0xcu});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8030$2136 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$3235
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n447__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n439__o.slice<7>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n439__o.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n439__o.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$3161 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$3162_CMP0 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$eq$top.v:427$64
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4814__o_5b_6_3a_0_5d_ = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4810__o.concat(logic_not<1>(value<29>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<4,3>()).val())).val(), value<1>{0x1u}) ? value<7>{0x5au} : value<7>{0x30u});
	// \src: top.v:4515.20-4515.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4515$1488
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<3,0>().val(), value<4>{0xfu});
	// \src: top.v:6449.20-6449.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6449$1806
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1062__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<11,8>().val());
	// \src: top.v:549.20-549.37
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$xor$top.v:549$91
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4915__o = xor_uu<8>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<12,5>().val(), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<87,80>().val());
	// \src: top.v:441.20-441.37
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$xor$top.v:441$67
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4827__o = xor_uu<8>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<12,5>().val(), p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4814__o_5b_6_3a_0_5d_);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6443$1804 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6441$1803 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:6439$1802 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:6435$1800
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<3>().val() ? (or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<2>().val()), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o) ? value<4>{0x5u} : value<4>{0xau}) : value<4>{0x2u});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8040$2138 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$3237
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n454__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n439__o.slice<6>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n447__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n447__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6445$1805 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:6423$1796
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<5>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o) ? value<4>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o);
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:559$93 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3283
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4923__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4915__o.slice<7>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4915__o.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4915__o.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:451$69 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3267
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4835__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4827__o.slice<7>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4827__o.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4827__o.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:6451.20-6451.47
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6451$1807
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1062__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<11,8>().val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$or$top.v:8206$2178 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:8204$2177 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:8202$2176
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n627__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<15,12>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<15,12>().val(), value<3>{0x6u}));
	// \src: top.v:8188.19-8188.36
	// cell $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:8188$2171
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n607__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<15,12>().val(), value<2>{0x3u});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8050$2140 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$3239
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n461__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n439__o.slice<5>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n454__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n454__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:4424.20-4424.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4424$1449
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1690__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<3,0>().val(), value<3>{0x7u});
	// \src: top.v:4422.20-4422.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4422$1448
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1687__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<3,0>().val(), value<3>{0x4u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6376$1783 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6374$1782 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6372$1781 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ge$top.v:6366$1779 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$le$top.v:6370$1780 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6362$1778 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:6360$1777 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6356$1776 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6352$1775
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter = and_uu<1>(and_uu<1>(and_uu<1>((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1062__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<44>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<45>().val())), (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<5>{0x1au}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<3>{0x7u})) ? value<1>{0x1u} : value<1>{0u}));
	// \src: top.v:7432.20-7432.41
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7432$2067
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1937__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<16>().val() ? value<1>{0u} : value<1>{0x1u});
	// \src: top.v:4426.20-4426.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4426$1450
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1687__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1690__o);
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:569$95 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3285
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4930__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4915__o.slice<6>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4923__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4923__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:461$71 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3269
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4842__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4827__o.slice<6>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4835__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4835__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8060$2142 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$3241
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n468__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n439__o.slice<4>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n461__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n461__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:4090.20-4090.38
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4090$1328
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2207__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<19,16>().val(), value<2>{0x2u});
	// \src: top.v:7492.20-7492.37
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7492$2088
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1995__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1937__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o);
	// \src: top.v:7175.20-7175.43
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7175$1981
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1683__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<89,81>().val());
	// \src: top.v:4411.20-4411.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4411$1443
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1522__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<3,0>().val());
	// \src: top.v:4388.20-4388.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4388$1432
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1518__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<3,0>().val(), value<2>{0x2u});
	// \src: top.v:4386.20-4386.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4386$1431
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1516__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<3,0>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$or$top.v:8266$2195 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:8264$2194 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:8262$2193
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n693__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<7,4>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<7,4>().val(), value<3>{0x6u}));
	// \src: top.v:8248.19-8248.36
	// cell $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:8248$2188
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n673__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<7,4>().val(), value<2>{0x3u});
	// \src: top.v:4078.20-4078.38
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4078$1324
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2192__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<19,16>().val(), value<3>{0x5u});
	// \src: top.v:4413.20-4413.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4413$1444
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1792__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<3,0>().val(), value<2>{0x3u});
	// \src: top.v:7434.20-7434.41
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7434$2068
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1943__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<16>().val() ? value<1>{0u} : value<1>{0u});
	// \src: top.v:6853.20-6853.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6853$1905
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1437__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<4>{0x9u});
	// \src: top.v:6817.20-6817.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6817$1897
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1411__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<4>{0x8u});
	// \src: top.v:4390.20-4390.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4390$1433
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1516__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1518__o);
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:579$97 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3287
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4937__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4915__o.slice<5>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4930__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4930__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:471$73 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3271
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4849__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4827__o.slice<5>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4842__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4842__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8070$2144 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$3243
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n475__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n439__o.slice<3>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n468__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n468__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:4382.20-4382.54
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4382$1429
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2525__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<109>().val() ? value<1>{0u} : value<1>{0x1u});
	// \src: top.v:4082.20-4082.38
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4082$1325
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2195__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<19,16>().val(), value<3>{0x6u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7456$2075 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7452$2074 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7446$2072
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1962__o = or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1062__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<90>().val()), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1683__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<89>().val());
	// \src: top.v:7058.20-7058.37
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7058$1953
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1576__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1411__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1437__o);
	// \src: top.v:6851.20-6851.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6851$1904
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x4u});
	// \src: top.v:6837.20-6837.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6837$1901
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x7u});
	// \src: top.v:6831.20-6831.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6831$1900
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x6u});
	// \src: top.v:6825.20-6825.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6825$1899
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<3>{0x5u});
	// \src: top.v:6809.20-6809.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6809$1895
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<2>{0x2u});
	// \src: top.v:6803.20-6803.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6803$1894
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<1>{0x1u});
	// \src: top.v:4441.20-4441.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4441$1457
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<3,0>().val(), value<4>{0x8u});
	// \src: top.v:6551.20-6551.28
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:6551$1843
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1161__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<101>().val());
	// \src: top.v:4432.20-4432.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4432$1453
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1786__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<3,0>().val(), value<3>{0x6u});
	// \src: top.v:4430.20-4430.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4430$1452
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1783__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<3,0>().val(), value<3>{0x5u});
	// \src: top.v:7280.20-7280.64
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ge$top.v:7280$2017
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1796__o = ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<48,41>().val(), value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:589$99 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3289
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4944__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4915__o.slice<4>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4937__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4937__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:481$75 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3273
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4856__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4827__o.slice<4>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4849__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4849__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:6533$1836 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6531$1835 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:6523$1832 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6521$1831 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6519$1830 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:6517$1829 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:6515$1828 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4138$1347 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:4136$1346
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1152__o = not_u<1>(and_uu<1>((reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<2,0>().val()) ? value<1>{0x1u} : value<1>{0u}), or_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<47>().val(), and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter), (ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u})))));
	// \src: top.v:6527.20-6527.28
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:6527$1833
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1149__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<102>().val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8080$2146 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$3245
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n482__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n439__o.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n475__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n475__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4498$1483 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4496$1482 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4494$1481 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4492$1480 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4490$1479
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1846__o = or_uu<1>(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<3,0>().val(), value<4>{0x9u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<3,0>().val(), value<4>{0xau})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<3,0>().val(), value<4>{0xbu}));
	// \src: top.v:4434.20-4434.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4434$1454
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1896__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1783__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1786__o);
	// \src: top.v:4415.20-4415.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4415$1445
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1884__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1522__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1792__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4407$1441 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4403$1439 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4397$1436
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2551__o = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2525__o, logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.curr)), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2525__o);
	// \src: top.v:7438.20-7438.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7438$2070
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1951__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<4>{0xau});
	// \src: top.v:6855.20-6855.37
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:6855$1906
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1437__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:6819$1898 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6815$1896
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field, value<2>{0x3u}), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1411__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2371 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2372_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2373_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2374_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2375_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2376_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2377_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2378_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7014$1931 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7034$1941 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7030$1939 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7026$1937 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7032$1940 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7028$1938 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7046$1947
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1593__o = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1576__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<1>{0x1u}) ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o ? value<4>{0xau} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1054__o) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1576__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<2>{0x2u}) ? ((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1522__o ? value<1>{0u} : value<1>{0x1u})) ? value<4>{0x4u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o ? value<4>{0x3u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1522__o ? value<4>{0xau} : value<4>{0u}))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1576__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<3>{0x4u}) ? value<4>{0x4u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1576__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<4>{0x8u}) ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o ? value<4>{0x6u} : value<4>{0xau}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1576__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<5>{0x10u}) ? value<4>{0x7u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1576__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<6>{0x20u}) ? value<4>{0x8u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1576__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<7>{0x40u}) ? value<4>{0x9u} : value<4>{0xau})))))));
	// \src: top.v:5026.20-5026.47
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5026$1636
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3006__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<109>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<13,3>().concat(value<3>{0x7u}).val() : value<3>{0x4u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<24,17>()).concat(value<3>{0x7u}).val());
	// \full_case: 1
	// \src: top.v:4520.19-4520.19|top.v:4520.5-4530.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2848_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2685__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1846__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1896__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1884__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<8>{0x80u});
	// \full_case: 1
	// \src: top.v:4786.38-4786.38|top.v:4779.5-4789.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2782_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2722__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1846__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1896__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1884__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:4524.38-4524.38|top.v:4520.5-4530.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2845_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2725__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1846__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1896__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1884__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:4583.38-4583.38|top.v:4577.5-4587.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2809_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2689__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1846__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1896__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1884__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:4582.38-4582.38|top.v:4577.5-4587.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2810_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2690__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1846__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1896__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1884__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<3>{0x4u});
	// \src: top.v:4399.20-4399.46
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4399$1437
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2546__o_5b_1_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2551__o ? value<2>{0x1u} : value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:4551.38-4551.38|top.v:4550.5-4560.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2828_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2708__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1846__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1896__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1884__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<7>{0x40u});
	// \src: top.v:4380.20-4380.60
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4380$1428
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2522__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<109>().val() ? value<3>{0x6u} : value<3>{0u});
	// \src: top.v:1405.20-1405.40
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1405$414
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<77,72>().val());
	// \src: top.v:1419.20-1419.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1419$419
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3728__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<2,0>().val(), value<2>{0x3u});
	// \src: top.v:1563.20-1563.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1563$463
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3901__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<6,3>().val(), value<3>{0x5u});
	// \src: top.v:7227.20-7227.42
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7227$1996
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1749__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<40,33>().val());
	// \full_case: 1
	// \src: top.v:6964.19-6964.19|top.v:6964.5-6973.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2387_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2387__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<7>{0x40u});
	// \src: top.v:6673.20-6673.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6673$1867
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1285__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<4>{0xdu});
	// \src: top.v:6638.20-6638.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6638$1860
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<5>{0x11u});
	// \src: top.v:6696.20-6696.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6696$1873
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1307__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<5>{0x13u});
	// \src: top.v:6640.20-6640.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6640$1861
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<4>{0xbu});
	// \src: top.v:6729.20-6729.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6729$1882
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1343__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<5>{0x10u});
	// \src: top.v:6727.20-6727.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6727$1881
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1340__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<5>{0x18u});
	// \src: top.v:6725.20-6725.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6725$1880
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1337__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<4>{0xeu});
	// \src: top.v:6644.20-6644.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6644$1863
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1262__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<3>{0x7u});
	// \src: top.v:6642.20-6642.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6642$1862
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1260__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<4>{0x9u});
	// \src: top.v:6636.20-6636.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6636$1859
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1250__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<4>{0x8u});
	// \src: top.v:6634.20-6634.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6634$1858
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1247__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<5>{0x17u});
	// \src: top.v:6632.20-6632.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6632$1857
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1244__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<42,38>().val(), value<5>{0x12u});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:599$101 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3291
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4951__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4915__o.slice<3>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4944__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4944__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:491$77 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3275
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4863__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4827__o.slice<3>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4856__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4856__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:8346$2215 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$not$top.v:8340$2213 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$not$top.v:8344$2214
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n770__o = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<37>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<36>().val()));
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8090$2148 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$3247
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n489__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n447__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n482__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n482__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:649.20-649.37
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$eq$top.v:649$114
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4764__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<2,0>().val(), value<1>{0x1u});
	// \src: top.v:5157.20-5157.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:5157$1656
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3049__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1518__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1792__o);
	// \src: top.v:5151.20-5151.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:5151$1653
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3040__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1522__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1516__o);
	// \src: top.v:1401.20-1401.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1401$413
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3709__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<2,0>().val(), value<3>{0x5u});
	// \src: top.v:1429.20-1429.28
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:1429$422
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3734__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<10>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4212$1372 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:4210$1371
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2350__o = (reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<73,70>().val()) ? value<1>{0x1u} : value<1>{0u});
	// \src: top.v:1700.20-1700.43
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1700$509
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4106__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<39,31>().val());
	// \src: top.v:1555.20-1555.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1555$459
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3889__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<6,3>().val(), value<2>{0x2u});
	// \src: top.v:1567.20-1567.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1567$465
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3904__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<6,3>().val(), value<3>{0x6u});
	// \src: top.v:1551.20-1551.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1551$457
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3886__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<6,3>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6511$1827 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2503 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2504_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6485$1819 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:6491$1822 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6489$1821 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6487$1820 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6493$1823 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6495$1824
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1062__o ? value<2>{0u}.concat((eq_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o, value<3>{0x7u}).concat(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o, value<3>{0x4u})).concat(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o, value<2>{0x2u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o, value<4>{0x9u}))).concat(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1059__o, value<1>{0x1u})).val(), value<4>{0x8u}) ? value<2>{0x3u} : value<2>{0x1u})).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<15,12>().val());
	// \full_case: 1
	// \src: top.v:6686.19-6686.19|top.v:6686.5-6690.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2478_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2478__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1285__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6687.33-6687.33|top.v:6686.5-6690.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2477_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2477__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1285__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:6713.19-6713.19|top.v:6713.5-6719.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2468_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2468__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1307__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1285__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:6714.35-6714.35|top.v:6713.5-6719.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2467_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2467__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1307__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1285__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:6715.35-6715.35|top.v:6713.5-6719.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2466_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2466__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1307__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1285__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6716.35-6716.35|top.v:6713.5-6719.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2465_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2465__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1307__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1285__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:6742.19-6742.19|top.v:6742.5-6748.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2456_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2456__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1343__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1340__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1337__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1307__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:6743.35-6743.35|top.v:6742.5-6748.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2455_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2455__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1343__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1340__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1337__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1307__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:6744.35-6744.35|top.v:6742.5-6748.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2454_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2454__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1343__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1340__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1337__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1307__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6745.35-6745.35|top.v:6742.5-6748.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2453_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2453__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1343__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1340__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1337__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1307__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:6654.34-6654.34|top.v:6648.5-6657.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2493_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2485__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1262__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1260__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1250__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1247__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1244__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:6653.34-6653.34|top.v:6648.5-6657.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2494_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2486__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1262__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1260__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1250__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1247__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1244__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6652.34-6652.34|top.v:6648.5-6657.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2495_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2487__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1262__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1260__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1250__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1247__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1244__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:6651.34-6651.34|top.v:6648.5-6657.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2496_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2488__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1262__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1260__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1250__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1247__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1244__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:6650.34-6650.34|top.v:6648.5-6657.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2497_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2489__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1262__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1260__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1250__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1247__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1244__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:6649.34-6649.34|top.v:6648.5-6657.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2498_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2490__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1262__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1260__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1256__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1253__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1250__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1247__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1244__o).val(), value<6>{0x20u});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$or$top.v:7963$2126 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6557$1846 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:6555$1845 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6553$1844 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6547$1842 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6545$1841 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$not$top.v:7961$2125
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_advance = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<46>().val()), and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1149__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1152__o), not_u<1>(and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<47>().val(), p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<48>().val()), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1161__o))));
	// \src: top.v:8146.19-8146.35
	// cell $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$or$top.v:8146$2159
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n530__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<31>().val(), p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<8>().val());
	// \src: top.v:8464.19-8464.36
	// cell $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:8464$2238
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n870__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<29,26>().val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$or$top.v:395$57 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$not$top.v:393$56
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_advance = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<25>().val()), p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_out__ready.curr);
	// \full_case: 1
	// \src: top.v:5211.33-5211.33|top.v:5209.5-5214.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2650_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2650__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1690__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3049__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3040__o).val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5135$1646 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2721 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2718 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2707
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3029__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<109>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<13,3>().concat(value<3>{0x7u}).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2708__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<42,41>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2685__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3006__o.slice<13,12>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<13,12>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2685__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3006__o.slice<11,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<11,3>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2685__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3006__o.slice<2,0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2725__CMP ? value<3>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2690__CMP ? value<3>{0x3u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2689__CMP ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2546__o_5b_1_3a_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2722__CMP ? value<3>{0x1u} : value<3>{0x7u})))))).val());
	// \src: top.v:4635.20-4635.41
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$add$top.v:4635$1501
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2687__o = add_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<10,3>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4627$1499 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2802 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2846_CMP0
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2682__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<109>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<60,58>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2685__CMP ? value<3>{0x4u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1846__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1896__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1884__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<5>{0x10u}) ? value<3>{0x2u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<60,58>().val())));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4624$1498 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2808 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4401$1438
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2680__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<109>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<56>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2689__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2551__o ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2690__CMP ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<56>().val())));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4629$1500 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2795 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2847_CMP0
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2683__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<109>().val() ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2522__o_5b_2_3a_0_5d_).val() : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1846__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1896__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1884__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<6>{0x20u}) ? value<4>{0x6u} : value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2522__o_5b_2_3a_0_5d_).val()));
	// \src: top.v:2913.20-2913.34
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:2913$1211
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3479__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3623__q.curr, value<2>{0x2u});
	// \src: top.v:1445.20-1445.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1445$428
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3751__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<2,0>().val(), value<3>{0x4u});
	// \src: top.v:1435.20-1435.43
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:1435$424
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3738__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<39,31>().val());
	// \src: top.v:4242.20-4242.28
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:4242$1378
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2376__o = not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2350__o);
	// \src: top.v:1710.20-1710.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1710$514
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4114__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4106__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3734__o);
	// \src: top.v:1575.20-1575.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1575$469
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3910__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<6,3>().val(), value<2>{0x3u});
	// \src: top.v:1659.20-1659.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1659$501
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4058__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<6,3>().val(), value<4>{0xbu});
	// \src: top.v:1655.20-1655.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1655$499
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4049__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<6,3>().val(), value<4>{0xau});
	// \src: top.v:1651.20-1651.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1651$497
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4040__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<6,3>().val(), value<4>{0x9u});
	// \src: top.v:1647.20-1647.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1647$495
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4031__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<6,3>().val(), value<4>{0x8u});
	// \src: top.v:1639.20-1639.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1639$491
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4013__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3889__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3904__o);
	// \src: top.v:1631.20-1631.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1631$487
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4001__o = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3886__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3901__o);
	// \src: top.v:1828.20-1828.45
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1828$555
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4110__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4106__o ? value<3>{0u} : value<3>{0x5u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7276$2016 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7272$2014 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7268$2012 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7264$2010
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1793__o = or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1687__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1783__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1786__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1690__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1792__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6797$1893 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$add$top.v:6793$1892
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1396__o = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<44>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<41,38>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<41,38>().val());
	// \src: top.v:6988.20-6988.35
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6988$1921
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1474__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left);
	// \src: top.v:7113.20-7113.42
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$add$top.v:7113$1966
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1635__o = add_uu<9>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<89,81>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6984$1919 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:6979$1918 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2386
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1470__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o) ? value<11>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<91>().concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2387__CMP ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<90>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<89,81>()).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:6406$1793 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6404$1792 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6402$1791
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1014__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<45,42>().val(), value<3>{0x4u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<45,42>().val(), value<3>{0x6u}));
	// \src: top.v:6388.19-6388.36
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6388$1786
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n994__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<45,42>().val(), value<2>{0x3u});
	// \full_case: 1
	// \src: top.v:6879.37-6879.37|top.v:6873.5-6882.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2429_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2429__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:6891.37-6891.37|top.v:6886.5-6895.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2426_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2426__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6903.37-6903.37|top.v:6899.5-6908.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2422_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2422__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:6915.37-6915.37|top.v:6912.5-6921.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2417_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2417__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:6927.37-6927.37|top.v:6925.5-6934.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2411_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2411__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:6939.37-6939.37|top.v:6938.5-6947.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2404_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2404__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1424__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1420__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1416__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1412__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1405__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1401__o).val(), value<6>{0x20u});
	// \src: top.v:6750.20-6750.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6750$1885
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1359__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<4,0>().val(), value<5>{0x11u});
	// \src: top.v:6721.20-6721.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6721$1878
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1331__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<4,0>().val(), value<3>{0x4u});
	// \src: top.v:6692.20-6692.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6692$1871
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1301__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<4,0>().val());
	// \src: top.v:6671.20-6671.39
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:6671$1866
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1282__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<4,0>().val(), value<5>{0x10u});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:609$103 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3293
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4958__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4915__o.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4951__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4951__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:501$79 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3277
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4870__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4827__o.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4863__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4863__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:8150.19-8150.41
	// cell $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:8150$2161
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n539__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<7,0>().val(), value<4>{0xdu});
	// \src: top.v:4172.20-4172.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4172$1360
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2297__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<2,0>().val(), value<3>{0x7u});
	// \src: top.v:1333.20-1333.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1333$392
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3651__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<2,0>().val());
	// \full_case: 1
	// \src: top.v:5177.33-5177.33|top.v:5175.5-5180.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2663
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3059__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2650__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3029__o.slice<13,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<13,3>().val());
	// \full_case: 1
	// \src: top.v:4810.38-4810.38|top.v:4809.5-4819.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2767
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2667__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2708__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<42,41>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2685__CMP ? value<2>{0x2u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<13,12>().val()));
	// \full_case: 1
	// \src: top.v:4786.38-4786.38|top.v:4779.5-4789.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2781
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2661__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2725__CMP ? value<3>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2690__CMP ? value<3>{0x3u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2689__CMP ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2546__o_5b_1_3a_0_5d_).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2722__CMP ? value<3>{0x1u} : value<3>{0x7u}))));
	// \src: top.v:1832.20-1832.46
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1832$557
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4112__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<10>().val() ? value<3>{0x4u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4110__o);
	// \src: top.v:1870.20-1870.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1870$572
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4319__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<2,0>().val(), value<3>{0x6u});
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7376$2050 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7372$2048
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1890__o = or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1884__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1687__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1690__o);
	// \full_case: 1
	// \src: top.v:6763.19-6763.19|top.v:6763.5-6769.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2444_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2444__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1359__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1331__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1301__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1282__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:6764.34-6764.34|top.v:6763.5-6769.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2443_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2443__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1359__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1331__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1301__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1282__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:6765.34-6765.34|top.v:6763.5-6769.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2442_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2442__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1359__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1331__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1301__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1282__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:6766.34-6766.34|top.v:6763.5-6769.12
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2441_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2441__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1359__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1331__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1301__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1282__o).val(), value<1>{0x1u});
	// \src: top.v:8669.19-8669.38
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:8669$2267
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n240__o = and_uu<1>(p_in__valid, p_in__ready.curr);
	// cells $flatten\unity_link_inst.\core_inst.\rx_register_inst.$or$top.v:8557$2257 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:7969$2128 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$not$top.v:7967$2127 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$not$top.v:8559$2258
	p_unity__link__inst_2e_core__inst_2e_fifo__out__ready = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_character__valid.curr), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_advance, not_u<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<33>().val())));
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:8166$2165 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$not$top.v:8160$2163 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:8164$2164
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n554__o = and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<29,26>().val(), value<4>{0xau}), not_u<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n530__o));
	// \src: top.v:8105.19-8105.39
	// cell $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8105$2152
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n499__o = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<16>().val() ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8103$2151 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8100$2150 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$auto$opt_expr.cc:702:replace_const_cells$3249
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n498__o = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<16>().val() ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n461__o_5b_2_3a_0_5d_.slice<2>().concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n468__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n475__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n482__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n489__o_5b_2_3a_0_5d_.slice<2>()).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n454__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n489__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n489__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val())).val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<25,18>().val());
	// \src: top.v:4174.20-4174.41
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4174$1361
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2304__o = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2297__o ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1329$391 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$and$top.v:403$60 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:401$59 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:1327$390
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance = or_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<88>().val()), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_advance, (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4764__o ? value<1>{0x1u} : value<1>{0u})));
	// \src: top.v:2983.20-2983.38
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ne$top.v:2983$1246
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3541__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_access__failure.curr);
	// \src: top.v:2901.20-2901.34
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:2901$1205
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3457__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3623__q.curr);
	// \src: top.v:4074.20-4074.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4074$1323
	p_unity__link__inst_2e_core__inst_2e_access__exclusive = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<18>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<57>().val());
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:2919$1214 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:2917$1213 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2915$1212
	p_unity__link__inst_2e_core__inst_2e_access__done = and_uu<1>((p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3479__o ? value<1>{0x1u} : value<1>{0u}), not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr));
	// \src: top.v:1856.20-1856.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1856$569
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4291__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<2,0>().val(), value<2>{0x2u});
	// \src: top.v:1737.20-1737.37
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1737$527
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4129__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<2,0>().val(), value<1>{0x1u});
	// \src: top.v:1686.20-1686.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1686$507
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4085__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<7,3>().val(), value<4>{0xeu});
	// memory \unity_link_inst.core_inst.frame_writer_inst.n4745 read port 0
	auto tmp_0 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<77,72>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_0.valid && "out of bounds read");
	if(tmp_0.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4746__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4745[tmp_0.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4746__data = value<4> {};
	}
	// \full_case: 1
	// \src: top.v:2158.19-2158.19|top.v:2158.5-2163.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3065_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3065__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4319__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3751__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3728__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:2159.36-2159.36|top.v:2158.5-2163.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3064_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3064__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4319__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3751__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3728__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:2160.33-2160.33|top.v:2158.5-2163.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3063_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3063__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4319__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3751__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3728__o).val(), value<1>{0x1u});
	// memory \unity_link_inst.core_inst.frame_writer_inst.n4751 read port 0
	auto tmp_1 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<77,72>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_1.valid && "out of bounds read");
	if(tmp_1.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4752__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4751[tmp_1.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4752__data = value<4> {};
	}
	// memory \unity_link_inst.core_inst.frame_writer_inst.n4749 read port 0
	auto tmp_2 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<77,72>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_2.valid && "out of bounds read");
	if(tmp_2.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4750__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4749[tmp_2.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4750__data = value<4> {};
	}
	// memory \unity_link_inst.core_inst.frame_writer_inst.n4747 read port 0
	auto tmp_3 = memory_index(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<77,72>().val(), 0, 64);
	CXXRTL_ASSERT(tmp_3.valid && "out of bounds read");
	if(tmp_3.valid) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4748__data = memory_p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4747[tmp_3.index];
	} else {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4748__data = value<4> {};
	}
	// \src: top.v:1585.20-1585.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1585$474
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3929__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<6,3>().val(), value<4>{0xdu});
	// \src: top.v:1589.20-1589.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1589$476
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3938__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<6,3>().val(), value<4>{0xeu});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1577$470 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1573$468 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1571$467 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1569$466 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1565$464 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1561$462
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3911__o = or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<6,3>().val(), value<3>{0x4u}), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3901__o), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3904__o), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<6,3>().val(), value<3>{0x7u})), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3910__o);
	// \src: top.v:1581.20-1581.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1581$472
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3920__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<6,3>().val(), value<4>{0xcu});
	// \src: top.v:1593.20-1593.38
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1593$478
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3947__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<6,3>().val(), value<4>{0xfu});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1557$460 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1553$458 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1549$456
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3890__o = or_uu<1>(or_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<6,3>().val()), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3886__o), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3889__o);
	// \src: top.v:1531.20-1531.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1531$451
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3861__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<7,3>().val(), value<5>{0x11u});
	// \src: top.v:1529.20-1529.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1529$450
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3857__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<7,3>().val(), value<5>{0x10u});
	// \src: top.v:92.20-92.39
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:92$2
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5065__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<25>().val(), p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_out__ready.curr);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7189$1986 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7177$1982 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7171$1980 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7167$1979
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1692__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1691__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1683__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<90>().val(), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<11,8>().val(), value<3>{0x4u}))));
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2506 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2507_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2508_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6386$1785 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$le$top.v:6384$1784 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6400$1790 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6398$1789 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ge$top.v:6392$1787 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$le$top.v:6396$1788
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1014__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n994__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<41,38>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1014__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n994__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<41,38>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<41,38>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u}));
	// \src: top.v:7163.20-7163.38
	// cell $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7163$1978
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1161__o, p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<48>().val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:619$105 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3295
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4965__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4923__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4958__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4958__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:511$81 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3279
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4877__o_5b_2_3a_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4835__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4870__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4870__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val());
	// \src: top.v:8671.19-8671.40
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:8671$2268
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n241__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr, p_unity__link__inst_2e_core__inst_2e_fifo__out__ready);
	// \src: top.v:8685.19-8685.40
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$eq$top.v:8685$2275
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n271__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8336$2212 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8328$2210 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8310$2206 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8308$2205 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8306$2204 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:8290$2201 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:8276$2197 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:8236$2185 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:8230$2184 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:8216$2180 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$procmux$2345 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$procmux$2346_CMP0 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$procmux$2347_CMP0 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8186$2170 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$le$top.v:8184$2169 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8200$2175 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:8198$2174 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ge$top.v:8192$2172 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$le$top.v:8196$2173 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:8228$2183 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8226$2182 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$add$top.v:8222$2181 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$procmux$2341 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$procmux$2342_CMP0 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$procmux$2343_CMP0 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8246$2187 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$le$top.v:8244$2186 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8260$2192 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:8258$2191 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ge$top.v:8252$2189 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$le$top.v:8256$2190 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:8288$2200 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8286$2199 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$add$top.v:8282$2198
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n762__o = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n554__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<53,48>().concat(value<2>{0u}).val() : (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n539__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<53,48>().concat(value<2>{0u}).val() : value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n530__o ? value<4>{0x9u} : (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<30>().val() ? value<4>{0x7u} : value<3>{0u}.concat((and_uu<1>(eq_uu<1>((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<6>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<3,0>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<3,0>().val()), p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<25,22>().val()), and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n693__o.concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n673__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<3,0>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n693__o.concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n673__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<3,0>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<3,0>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<16>().val(), and_uu<1>(eq_uu<1>((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<14>().val() ? add_uu<4>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<11,8>().val(), value<4>{0x9u}) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<11,8>().val()), p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<21,18>().val()), and_uu<1>((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n627__o.concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n607__o).val(), value<1>{0x1u}) ? (le_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<11,8>().val(), value<4>{0x9u}) ? value<1>{0x1u} : value<1>{0u}) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n627__o.concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n607__o).val(), value<2>{0x2u}) ? (and_uu<1>(le_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<11,8>().val(), value<3>{0x6u}), ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<11,8>().val(), value<1>{0x1u})) ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})), p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<17>().val()))))) ? value<1>{0u} : value<1>{0x1u})).val()))).concat(value<3>{0x3u}).val()));
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$or$top.v:8152$2162 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:8148$2160
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n540__o = or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<7,0>().val(), value<4>{0xau}), p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n539__o);
	// \src: top.v:8460.19-8460.43
	// cell $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8460$2237
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n867__o = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n770__o ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<45,38>()).val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n499__o.concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<7,0>()).val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8332$2211 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8317$2207 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8320$2208 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8324$2209
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n759__o = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n554__o ? value<22>{0x102800u} : (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n539__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<37,34>().val() : value<4>{0x4u}).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n539__o ? value<1>{0x1u} : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n539__o ? value<1>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n530__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<30,16>()).val() : value<17>{0x2800u})).val());
	// \src: top.v:8456.19-8456.43
	// cell $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8456$2236
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n864__o = (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n770__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<25,0>().val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n498__o.concat(value<1>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<17>()).concat(p_unity__link__inst_2e_core__inst_2e_character__in.curr.slice<7,0>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<15,8>()).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4104$1333 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4102$1332
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word = (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<46,39>().val(), value<1>{0x1u}) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4098$1331 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4096$1330
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2207__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2195__o) ? value<1>{0x1u} : value<1>{0u});
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4248$1381 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4246$1380 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4244$1379 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4240$1377
	p_unity__link__inst_2e_core__inst_2e_answer__has__id = or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<20>().val(), (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2376__o, eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<19,16>().val(), value<4>{0xfu})) ? value<1>{0x1u} : value<1>{0u}));
	// \full_case: 1
	// \src: top.v:2406.19-2406.19|top.v:2406.5-2415.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2934_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2934__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4319__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3709__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3751__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3728__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4291__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4129__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3651__o).val(), value<7>{0x40u});
	// \full_case: 1
	// \src: top.v:2407.37-2407.37|top.v:2406.5-2415.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2933_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2933__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4319__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3709__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3751__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3728__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4291__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4129__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3651__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:2408.37-2408.37|top.v:2406.5-2415.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2932_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2932__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4319__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3709__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3751__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3728__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4291__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4129__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3651__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:2409.37-2409.37|top.v:2406.5-2415.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2931_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2931__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4319__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3709__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3751__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3728__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4291__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4129__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3651__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:2412.37-2412.37|top.v:2406.5-2415.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2928_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2928__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4319__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3709__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3751__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3728__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4291__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4129__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3651__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:2410.37-2410.37|top.v:2406.5-2415.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2930_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4319__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3709__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3751__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3728__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4291__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4129__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3651__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:2411.37-2411.37|top.v:2406.5-2415.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2929_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2929__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4319__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3709__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3751__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3728__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4291__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4129__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3651__o).val(), value<2>{0x2u});
	// \src: top.v:1682.20-1682.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:1682$506
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4080__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<7,3>().val(), value<5>{0x12u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1798$550 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3082 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3083_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3084_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3085_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3086_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3087_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3088_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3089_CMP0
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4071__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<7>().val() ? value<5>{0u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4058__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4049__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4040__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4031__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3910__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4013__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4001__o).val(), value<1>{0x1u}) ? value<5>{0xdu} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4058__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4049__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4040__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4031__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3910__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4013__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4001__o).val(), value<2>{0x2u}) ? value<5>{0x11u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4058__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4049__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4040__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4031__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3910__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4013__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4001__o).val(), value<3>{0x4u}) ? value<5>{0xbu} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4058__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4049__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4040__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4031__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3910__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4013__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4001__o).val(), value<4>{0x8u}) ? value<5>{0x13u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4058__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4049__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4040__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4031__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3910__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4013__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4001__o).val(), value<5>{0x10u}) ? value<5>{0xeu} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4058__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4049__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4040__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4031__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3910__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4013__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4001__o).val(), value<6>{0x20u}) ? value<5>{0x18u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4058__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4049__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4040__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4031__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3910__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4013__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4001__o).val(), value<7>{0x40u}) ? value<5>{0x10u} : value<5>{0u}))))))));
	// \full_case: 1
	// \src: top.v:1878.33-1878.33|top.v:1876.5-1881.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3077
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4322__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3063__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<18,15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3064__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<30,27>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3065__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4746__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<71,68>().val())));
	// \full_case: 1
	// \src: top.v:2160.33-2160.33|top.v:2158.5-2163.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3062
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4622__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3063__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<18,15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3064__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<30,27>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3065__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4752__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<71,68>().val())));
	// \full_case: 1
	// \src: top.v:2060.33-2060.33|top.v:2058.5-2063.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3067
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4518__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3063__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<18,15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3064__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<30,27>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3065__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4750__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<71,68>().val())));
	// \full_case: 1
	// \src: top.v:1974.33-1974.33|top.v:1972.5-1977.12
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3072
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4425__o = (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3063__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<18,15>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3064__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<30,27>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_3065__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4748__data : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<71,68>().val())));
	// \src: top.v:108.20-108.41
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$eq$top.v:108$10
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5096__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<1>{0x1u});
	// \src: top.v:94.20-94.41
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:94$3
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5066__o = and_uu<1>(p_out__valid.curr, p_out__ready);
	// \src: top.v:678.20-678.37
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$eq$top.v:678$121
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5015__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<2,0>().val(), value<2>{0x2u});
	// \src: top.v:680.20-680.37
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$eq$top.v:680$122
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5020__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<2,0>().val(), value<2>{0x3u});
	// \src: top.v:684.20-684.37
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$eq$top.v:684$123
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5029__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<2,0>().val(), value<3>{0x4u});
	// \src: top.v:545.20-545.37
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$eq$top.v:545$90
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4901__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<2,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:8711$2288 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$not$top.v:8709$2287
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n289__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n241__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n240__o));
	// \src: top.v:7993.19-7993.34
	// cell $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$eq$top.v:7993$2130
	p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n390__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<17,16>().val());
	// \src: top.v:4130.20-4130.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4130$1344
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2260__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<2,0>().val());
	// \src: top.v:5462.20-5462.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:5462$1744
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3263__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<2,0>().val(), value<3>{0x6u});
	// \src: top.v:5457.20-5457.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:5457$1742
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3258__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<2,0>().val(), value<3>{0x5u});
	// \src: top.v:5431.20-5431.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:5431$1735
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3232__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<2,0>().val(), value<3>{0x4u});
	// \src: top.v:5426.20-5426.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:5426$1733
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3227__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<2,0>().val(), value<2>{0x3u});
	// \src: top.v:5334.20-5334.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:5334$1704
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3152__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<2,0>().val(), value<2>{0x2u});
	// \src: top.v:5332.20-5332.37
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:5332$1703
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3148__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<2,0>().val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1339$395 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4224$1376 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:4222$1375 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1337$394 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1335$393
	p_unity__link__inst_2e_core__inst_2e_answer__taken = and_uu<1>(and_uu<1>((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3651__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2304__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<22>().val())));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4126$1343 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4124$1342
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__done, (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3541__o ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5272$1683 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5257$1677 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4878$1571 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2778 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5230$1668 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5221$1665 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2666 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2668_CMP0 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5234$1669 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5237$1670 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5241$1671 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4619$1496 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2838
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3105__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<14>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<109>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<13,12>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2687__o).concat(value<3>{0x7u}).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2667__o.concat(value<1>{0u}).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2685__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<24,17>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2687__o)).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2661__o).val()) : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<13,12>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3059__o.slice<10,9>().val()).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<15>().val() ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3059__o.slice<8>().val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<10,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3059__o.slice<7,0>().val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<15>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<11>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<2,0>().val() : value<3>{0x7u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2650__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3029__o.slice<2,0>().val() : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1690__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3049__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3040__o).val(), value<3>{0x4u}) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<2,0>().val() : value<3>{0x7u})))).val()) : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<109>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<13,3>().concat(value<3>{0x7u}).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2667__o.concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2685__CMP ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<24,17>()).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<11,3>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2661__o).val()));
	// \src: top.v:4374.20-4374.44
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ne$top.v:4374$1425
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2505__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<108,105>().val());
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:2905$1207 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2903$1206 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:2899$1204 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:2897$1203
	p_unity__link__inst_2e_core__inst_2e_access__granted = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<56>().val(), not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3496__o.curr)), (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3457__o ? value<1>{0x1u} : value<1>{0u}));
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4168$1359 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:4166$1358 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4120$1340 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4118$1339 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4116$1338
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2293__o = and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__done, (logic_not<1>(p_unity__link__inst_2e_core__inst_2e_access__failure.curr) ? value<1>{0x1u} : value<1>{0u})), not_u<1>(p_unity__link__inst_2e_core__inst_2e_access__exclusive));
	// cell $auto$opt_reduce.cc:131:opt_pmux$3403
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3341 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2931__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2932__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2933__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2934__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1854$568 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1848$565 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1842$562 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1830$556
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4123__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4080__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4085__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<9>().val() ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4114__o ? value<1>{0x1u} : value<1>{0u}))));
	// \src: top.v:1678.20-1678.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:1678$505
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4073__o = reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4071__o);
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2126$632 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$eq$top.v:2119$629
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4583__o = and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<39,31>().val(), value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o);
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1850$566 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1844$563 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1838$560
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4121__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4080__o ? value<3>{0x5u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4085__o ? value<3>{0x6u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<9>().val() ? value<3>{0x3u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4112__o)));
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1852$567 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1846$564 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1840$561
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4122__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4080__o ? value<6>{0x3u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4085__o ? value<6>{0x3fu} : value<2>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<9>().val() ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<22,19>().val() : value<4>{0x1u})).val()));
	// \src: top.v:1921.20-1921.39
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$sub$top.v:1921$581
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4362__o = sub_uu<6>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<77,72>().val(), value<1>{0x1u});
	// \src: top.v:2961.20-2961.48
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:2961$1235
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3520__o = logic_not<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3629__q.curr);
	// \src: top.v:2981.20-2981.34
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$eq$top.v:2981$1245
	p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3539__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3623__q.curr, value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:134$23 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$not$top.v:132$22
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5114__o = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5066__o, not_u<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5065__o));
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7557$2111 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7211$1991
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2054__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o ? value<1>{0x1u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1692__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<88,81>().concat(value<1>{0x1u}).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<100,93>().concat(value<1>{0u}).val())).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<101,93>().concat(value<1>{0u}).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7157$1976 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7141$1973 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7129$1970 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2368 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2369_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7077$1955 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7083$1958 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7081$1957 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7079$1956 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7085$1959 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7087$1960 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$sub$top.v:6986$1920 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2431 $auto$opt_reduce.cc:131:opt_pmux$3386 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7147$1974 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2428 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2425 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2421 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2416 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2410 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2403 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2395 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6849$1903 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7121$1968 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7131$1971 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7116$1967 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7135$1972 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7125$1969
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<100,93>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<91,8>()).val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1474__o ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<88,81>().concat(value<1>{0x1u}).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<100,93>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<100,93>().concat(value<1>{0u}).val()).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1470__o.slice<10>()).concat((and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1438__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1474__o) ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<89>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1470__o.slice<8,0>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1635__o)).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1470__o.slice<9,0>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2387__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<90>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<76,73>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1396__o).val() : value<4>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1396__o).val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<80,73>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2404__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<68,57>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1396__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<72,57>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2411__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<52,49>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1396__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<56,49>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2417__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<44,41>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1396__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<48,41>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2422__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<36,33>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1396__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<40,33>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2426__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<28,25>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1396__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<32,25>().val())).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2429__CMP ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<20,17>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1396__o).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<24,17>().val())).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<100,93>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<91,17>()).val()).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_digit ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2387__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2404__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2411__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2417__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2422__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2426__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2429__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<16>().val() : value<1>{0x1u}).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1474__o ? value<2>{0u}.concat((eq_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1593__o, value<3>{0x7u}).concat(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1593__o, value<3>{0x4u})).concat(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1593__o, value<2>{0x2u}), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1593__o, value<4>{0x9u}))).concat(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1593__o, value<1>{0x1u})).val(), value<4>{0x8u}) ? value<2>{0x3u} : value<2>{0x1u})).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1593__o).val() : sub_uu<4>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left, value<1>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field).val())).val() : value<1>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_left).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_field).val())).val());
	// \full_case: 1
	// \src: top.v:732.35-732.35|top.v:729.5-736.12
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$3135_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3114__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5029__o.concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5020__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5015__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4764__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4901__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:721.35-721.35|top.v:717.5-724.12
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$3141_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3113__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5029__o.concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5020__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5015__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4764__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4901__o).val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:730.35-730.35|top.v:729.5-736.12
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$3137_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3116__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5029__o.concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5020__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5015__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4764__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4901__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:731.35-731.35|top.v:729.5-736.12
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$3136_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3115__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5029__o.concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5020__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5015__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4764__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4901__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:729.19-729.19|top.v:729.5-736.12
	// cell $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$3138_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3117__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5029__o.concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5020__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5015__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4764__o).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4901__o).val(), value<5>{0x10u});
	// \full_case: 1
	// \src: top.v:5658.38-5658.38|top.v:5657.5-5667.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2526_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2526__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2297__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3263__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3232__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3227__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3152__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3148__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2260__o).val(), value<7>{0x40u});
	// \full_case: 1
	// \src: top.v:5660.38-5660.38|top.v:5657.5-5667.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2524_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2524__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2297__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3263__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3232__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3227__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3152__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3148__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2260__o).val(), value<5>{0x10u});
	// \src: top.v:5435.20-5435.44
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:5435$1736
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3237__o = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<54,47>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<117,110>().val());
	// \full_case: 1
	// \src: top.v:5657.19-5657.19|top.v:5657.5-5667.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2527_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2527__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2297__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3263__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3232__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3227__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3152__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3148__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2260__o).val(), value<8>{0x80u});
	// \full_case: 1
	// \src: top.v:5659.38-5659.38|top.v:5657.5-5667.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2525_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2525__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2297__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3263__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3232__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3227__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3152__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3148__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2260__o).val(), value<6>{0x20u});
	// \full_case: 1
	// \src: top.v:5661.38-5661.38|top.v:5657.5-5667.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2523_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2523__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2297__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3263__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3232__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3227__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3152__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3148__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2260__o).val(), value<4>{0x8u});
	// \full_case: 1
	// \src: top.v:5662.38-5662.38|top.v:5657.5-5667.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2522_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2297__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3263__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3232__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3227__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3152__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3148__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2260__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:5663.38-5663.38|top.v:5657.5-5667.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2521_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2521__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2297__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3263__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3232__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3227__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3152__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3148__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2260__o).val(), value<2>{0x2u});
	// \src: top.v:5342.20-5342.41
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$add$top.v:5342$1706
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3157__o = add_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<54,47>().val(), value<1>{0x1u});
	// \full_case: 1
	// \src: top.v:5664.38-5664.38|top.v:5657.5-5667.12
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2520_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2520__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2297__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3263__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3258__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3232__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3227__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3152__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3148__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2260__o).val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1463$435 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1461$434 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1459$433 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1457$432 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1451$430 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1441$427 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1439$426 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1437$425 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1431$423 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1425$421 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1415$418 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1413$417 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1407$415 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ne$top.v:1411$416
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word = and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance, or_uu<1>(or_uu<1>((and_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<39,31>().val(), value<1>{0x1u}), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3709__o)) ? value<1>{0x1u} : value<1>{0u}), (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3738__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3734__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3728__o))) ? value<1>{0x1u} : value<1>{0u})), (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3738__o, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3751__o)) ? value<1>{0x1u} : value<1>{0u})));
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1509$444 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$or$top.v:1467$436 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4266$1387 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4262$1385 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:4260$1384 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:4256$1383 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4346$1417 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4314$1407 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2850 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4306$1405 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4304$1404 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4302$1403 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4300$1402 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4298$1401 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4296$1400 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4294$1399 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4292$1398 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4290$1397 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4288$1396 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4286$1395 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4282$1393 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4278$1391 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4274$1389 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1471$437 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4338$1415 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4348$1418 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4252$1382
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3835__o = (p_unity__link__inst_2e_core__inst_2e_answer__taken ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2350__o ? value<4>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<73,70>()).val() : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<19>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<48,41>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<117,110>().val())).concat(value<4>{0x1u}).concat((p_unity__link__inst_2e_core__inst_2e_answer__has__id ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<74>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<10,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<30,23>().val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<32,25>().val())).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2350__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<20>().val() ? value<1>{0u} : (or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<19,16>().val(), value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2207__o), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2192__o), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2195__o), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<19,16>().val(), value<4>{0x8u})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<19,16>().val(), value<4>{0x9u})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<19,16>().val(), value<4>{0xau})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<19,16>().val(), value<4>{0xbu})), eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<19,16>().val(), value<4>{0xcu})) ? value<1>{0x1u} : value<1>{0u})))).concat(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_answer__has__id, and_uu<1>(and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<20>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<19>().val())), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2376__o))).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<30,9>().val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$3384
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3317 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2929__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2931__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2932__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2933__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2934__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1505$443 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4344$1416 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4336$1414
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3832__o = (p_unity__link__inst_2e_core__inst_2e_answer__taken ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<20>().concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2350__o ? value<5>{0x10u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<74>().val() ? value<5>{0x11u} : value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<19,16>()).val()))).concat(value<3>{0x1u}).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<8,0>().val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$3314
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3315 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2929__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP).val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$3348
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3347 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2929__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2931__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2932__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2934__CMP).val());
	// \src: top.v:1519.20-1519.51
	// cell $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1519$447
	p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3842__o = (p_unity__link__inst_2e_core__inst_2e_answer__taken ? value<2>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<79,78>().val());
	// cells $flatten\unity_link_inst.\wishbone_master_inst.$and$top.v:8864$2328 $flatten\unity_link_inst.\wishbone_master_inst.$or$top.v:8862$2327
	p_unity__link__inst_2e_bus__done = and_uu<1>(p_wb__stb.curr, or_uu<1>(p_wb__ack, p_wb__err));
	// \full_case: 1
	// \src: top.v:3098.19-3098.19|top.v:3098.5-3103.12
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2865_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3479__o.concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3539__o).concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3457__o).val(), value<3>{0x4u});
	// \full_case: 1
	// \src: top.v:3099.35-3099.35|top.v:3098.5-3103.12
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2864_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2864__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3479__o.concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3539__o).concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3457__o).val(), value<2>{0x2u});
	// \full_case: 1
	// \src: top.v:3100.33-3100.33|top.v:3098.5-3103.12
	// cell $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2863_CMP0
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2863__CMP = eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3479__o.concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3539__o).concat(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3457__o).val(), value<1>{0x1u});
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:537$87 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:532$86 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$eq$top.v:529$85 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$add$top.v:525$84 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:521$83 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3281
	p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4896__o = (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<88>().val() ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4849__o_5b_2_3a_0_5d_.slice<2>().concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4856__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4863__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4870__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4877__o_5b_2_3a_0_5d_.slice<2>()).concat((p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4842__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4877__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4877__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val())).concat(add_uu<2>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<4,3>().val(), value<1>{0x1u})).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<4,3>().val(), value<2>{0x2u}) ? value<3>{0x1u} : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<2,0>().val())).val() : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<12,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:8701$2283 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$not$top.v:8699$2282
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n281__o = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n241__o), p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n240__o);
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:8691$2278 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$or$top.v:8689$2277 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:8687$2276 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$eq$top.v:8683$2274
	p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n274__o = and_uu<1>(or_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n241__o, p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n271__o)), p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n240__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5312$1696 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5288$1689 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5292$1690
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3132__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<102>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2505__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<13,3>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3105__o.slice<13,3>().val()).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2505__o ? value<3>{0x7u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3105__o.slice<2,0>().val())).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<13,0>().val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$3405
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3353 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2521__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2523__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2524__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2525__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2526__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2527__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5315$1697 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5294$1691 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5274$1684
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3134__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<102>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<117,110>().concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<32,17>()).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<104,103>()).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2505__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<5>().val() ? value<1>{0x1u} : value<1>{0u}))).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<3,0>()).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<46,16>().val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$3366
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3355 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2521__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2524__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2525__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2526__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2527__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5317$1698 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5297$1692 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5276$1685 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5261$1679 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5246$1673 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2656 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5300$1693 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5278$1686 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5263$1680 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5249$1674 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2653
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3135__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<102>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2505__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<60,58>().val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<14>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2682__o : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<60,58>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2650__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2682__o : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<60,58>().val()))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2682__o)).concat(value<1>{0u}).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2505__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<56>().val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<14>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2680__o : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<15>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<56>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2650__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2680__o : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<56>().val()))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2680__o))).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<60,56>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5320$1699 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5303$1694 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5281$1687 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5266$1681 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5251$1675 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2649 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2651_CMP0 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5306$1695 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5284$1688 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5269$1682 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5253$1676 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5226$1667
	p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3137__o = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<102>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2505__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<14>().val() ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<15>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<11>().val() ? value<1>{0u} : value<1>{0x1u}) : value<1>{0u})) : value<1>{0u})).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2505__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<108,105>().val() : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<5>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<14>().val() ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2683__o : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<15>().val() ? value<4>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2650__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2683__o : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1690__o.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3049__o).concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3040__o).val(), value<2>{0x2u}) ? value<4>{0x8u} : value<4>{0u})))) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2683__o))).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<74,70>().val());
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:3226$1296 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4188$1366 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4186$1365 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:3224$1295 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$add$top.v:3222$1294
	p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3383__o = (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed, and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2304__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<22>().val())) ? p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.curr : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2293__o ? add_uu<2>(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3416__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3416__q.curr));
	// cell $auto$opt_reduce.cc:131:opt_pmux$3334
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3329 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2864__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP).val());
	// cell $auto$opt_reduce.cc:131:opt_pmux$3338
	i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3337 = reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2863__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP).val());
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:114$13 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$or$top.v:112$12 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:110$11 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$eq$top.v:106$9
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5099__o = and_uu<1>(or_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr), and_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5066__o, p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5096__o)), p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5065__o);
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:124$18 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$not$top.v:122$17
	p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5106__o = and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5066__o), p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5065__o);
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7588$2119 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4132$1345
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2076__o = and_uu<1>((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2260__o ? value<1>{0x1u} : value<1>{0u}), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<102>().val());
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7584$2118 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6535$1837 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:6529$1834 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7566$2113 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7152$1975 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:6771$1888 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2446 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2492 $auto$opt_reduce.cc:131:opt_pmux$3382 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2480 $auto$opt_reduce.cc:131:opt_pmux$3394 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2470 $auto$opt_reduce.cc:131:opt_pmux$3392 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2458 $auto$opt_reduce.cc:131:opt_pmux$3388 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2440 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2484 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2476 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2464 $auto$opt_reduce.cc:131:opt_pmux$3390 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2452 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:6779$1889 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:6787$1891 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:6785$1890 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7569$2114 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7207$1990 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7553$2110 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7202$1989 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7572$2115 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7576$2116 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7580$2117 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7560$2112 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7549$2109 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:7394$2055 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7547$2108 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7426$2065 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7408$2059 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:7398$2056 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:7406$2058 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7404$2057 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:7424$2064 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7422$2063 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7420$2062 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7414$2060 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7545$2107 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7541$2105 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2349 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2350_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2351_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2352_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7508$2096 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7504$2094 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7500$2092 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7496$2090 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7488$2086 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7502$2093 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7498$2091 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7468$2079 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7490$2087 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7486$2085 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7524$2100 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$not$top.v:7514$2098 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7522$2099 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7358$2043 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2358 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2359_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2360_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2361_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2362_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2363_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7233$1998 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:7231$1997 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7256$2006 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$and$top.v:7249$2005 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:7245$2003 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:7247$2004 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7313$2027 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7306$2026 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:7304$2025 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7300$2024 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7294$2022 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$eq$top.v:7292$2021 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$or$top.v:7288$2020 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ne$top.v:7286$2019 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$gt$top.v:7337$2037 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2354 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2355_CMP0 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procmux$2356_CMP0
	p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2074__o = (and_uu<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<46>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1149__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1152__o) ? (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<47>().val() ? (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<117,102>().val() : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1896__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1890__o).val(), value<1>{0x1u}) ? value<8>{0x1u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1896__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1890__o).val(), value<2>{0x2u}) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<88,81>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<40,33>().val())).concat(((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1846__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1793__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<1>{0x1u}) ? or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1749__o, gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<40,33>().val(), value<1>{0x1u})) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1846__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1793__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<2>{0x2u}) ? or_uu<1>(and_uu<1>(ne_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<3,0>().val(), value<2>{0x3u}), gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<89,81>().val(), value<1>{0x1u})), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<91>().val()) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1846__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1793__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<3>{0x4u}) ? or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1796__o, reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<56,55>().concat(value<2>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<52,50>()).concat(value<1>{0u}).val())), logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<72,57>().val())), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1749__o), gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<40,33>().val(), value<6>{0x20u})), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<91>().val()) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1846__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1793__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<4>{0x8u}) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1796__o : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1049__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1846__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1548__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1793__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1519__o).val(), value<5>{0x10u}) ? gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<48,41>().val(), value<2>{0x2u}) : value<1>{0u}))))) ? value<1>{0x1u} : value<1>{0u})).concat((reduce_bool<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<52,49>().val()) ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<52,49>().val() : (and_uu<1>(not_u<1>(and_uu<1>(or_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<3,0>().val(), value<4>{0xeu}), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1026__o), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<5>().val())), and_uu<1>(not_u<1>(and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<6>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<7>().val())), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<4>().val()))) ? value<2>{0u}.concat(((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<16>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1943__o : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1437__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1951__o).val(), value<1>{0x1u}) ? value<1>{0x1u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1437__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1951__o).val(), value<2>{0x2u}) ? ((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<16>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1937__o : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1962__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1792__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1995__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1937__o)))) ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1962__o ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1792__o ? eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<89,81>().val(), value<2>{0x2u}) : (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1995__o ? eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<89,81>().val(), value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1943__o)))) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1437__o.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1435__o).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1951__o).val(), value<3>{0x4u}) ? and_uu<1>(eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<89,81>().val(), p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<40,33>().val()), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<90>().val())) : value<1>{0u})))) ? value<2>{0u} : value<2>{0x3u})).val() : value<4>{0x2u}))).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<53>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<48>()).concat(value<1>{0x1u}).val()).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2054__o.slice<9>()).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<117,101>().val()).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<47>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2054__o.slice<8,0>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o.slice<92,84>().val())).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<47>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<91>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o.slice<83>().val())).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<47>().val() ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1692__o, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1674__o) ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<89>().val() ? value<1>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<88,81>()).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1635__o)).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<90,81>().val()) : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o.slice<82,73>().val())).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<47>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<80,0>().val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n1671__o.slice<72,0>().concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_letter ? or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<7>().val(), not_u<1>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<43>().val())).concat(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<6>().val(), p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<43>().val())).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<43>()).concat(((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2441__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2485__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2486__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2487__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2488__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2489__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2490__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2442__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2477__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2478__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2443__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2465__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2466__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2467__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2468__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2444__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2453__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2454__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2455__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2456__CMP).val()) ? value<1>{0u} : value<1>{0x1u}) : value<1>{0x1u})))) ? value<5>{0x1fu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2441__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2485__CMP ? value<5>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2486__CMP ? value<5>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2487__CMP ? value<5>{0xdu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2488__CMP ? value<5>{0xeu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2489__CMP ? value<5>{0xfu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2490__CMP ? value<5>{0x1fu} : value<5>{0u})))))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2442__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2477__CMP ? value<5>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2478__CMP ? value<5>{0x1fu} : value<5>{0u})) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2443__CMP ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2467__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2468__CMP).val()) ? value<5>{0x1fu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2466__CMP ? value<5>{0x7u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2465__CMP ? value<5>{0x5u} : value<5>{0u}))) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2444__CMP ? (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2453__CMP ? value<5>{0x8u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2454__CMP ? value<5>{0x9u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2455__CMP ? value<5>{0xau} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__decoder__inst_2e__24_procmux_24_2456__CMP ? value<5>{0xbu} : value<5>{0u})))) : value<5>{0u})))))).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<7,0>().val())).val())).val() : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<117,93>().concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<91,0>()).val());
	// memory \unity_link_inst.core_inst.rx_fifo_inst.memory read port 0
	auto tmp_4 = memory_index(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n329__q.curr, 0, 256);
	CXXRTL_ASSERT(tmp_4.valid && "out of bounds read");
	if(tmp_4.valid) {
		value<9> tmp_5 = memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory[tmp_4.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_8769_24_2313__DATA = tmp_5;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_8769_24_2313__DATA = value<9> {};
	}
	// memory \unity_link_inst.core_inst.tx_fifo_inst.memory read port 0
	auto tmp_6 = memory_index(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5154__q.curr, 0, 256);
	CXXRTL_ASSERT(tmp_6.valid && "out of bounds read");
	if(tmp_6.valid) {
		value<10> tmp_7 = memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory[tmp_6.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_192_24_48__DATA = tmp_7;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_192_24_48__DATA = value<10> {};
	}
	// \full_case: 1
	// \src: top.v:5694.9-5694.14|top.v:5694.5-5695.41
	// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procmux$2510
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_5695_24_1764__EN_5b_7_3a_0_5d__24_1770_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<92>().val() ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:194.9-194.13|top.v:194.5-195.35
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$3164
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_195_24_1__EN_5b_9_3a_0_5d__24_52_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5065__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:8771.9-8771.13|top.v:8771.5-8772.35
	// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$2330
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_8772_24_2266__EN_5b_8_3a_0_5d__24_2317_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n240__o ? value<1>{0x1u} : value<1>{0u});
	// \full_case: 1
	// \src: top.v:3272.9-3272.14|top.v:3272.5-3273.37
	// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procmux$2853
	i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_3273_24_1293__EN_5b_7_3a_0_5d__24_1319_5b_0_5d_ = (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2293__o ? value<1>{0x1u} : value<1>{0u});
	// memory \unity_link_inst.core_inst.response_ring_inst.memory read port 0
	auto tmp_8 = memory_index(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3418__q.curr.slice<0>().val(), 0, 2);
	CXXRTL_ASSERT(tmp_8.valid && "out of bounds read");
	if(tmp_8.valid) {
		value<8> tmp_9 = memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory[tmp_8.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3423__data_5b_7_3a_0_5d_ = tmp_9;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3423__data_5b_7_3a_0_5d_ = value<8> {};
	}
	// memory \unity_link_inst.core_inst.request_memory_inst.memory read port 0
	auto tmp_10 = memory_index(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<47>().val(), 0, 2);
	CXXRTL_ASSERT(tmp_10.valid && "out of bounds read");
	if(tmp_10.valid) {
		value<8> tmp_11 = memory_p_unity__link__inst_2e_core__inst_2e_request__memory__inst_2e_memory[tmp_10.index];
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2155__data_5b_7_3a_0_5d_ = tmp_11;
	} else {
		i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2155__data_5b_7_3a_0_5d_ = value<8> {};
	}
	// memory \unity_link_inst.core_inst.request_memory_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:5694.9-5694.14|top.v:5694.5-5695.41
		// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procmux$2516
		auto tmp_12 = memory_index((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<92>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<93>().val() : value<1>{0u}), 0, 2);
		CXXRTL_ASSERT(tmp_12.valid && "out of bounds write");
		if (tmp_12.valid) {
			// \full_case: 1
			// \src: top.v:5694.9-5694.14|top.v:5694.5-5695.41
			// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procmux$2513
			memory_p_unity__link__inst_2e_core__inst_2e_request__memory__inst_2e_memory.update(tmp_12.index, (p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<92>().val() ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<80,73>().val() : value<8>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_5695_24_1764__EN_5b_7_3a_0_5d__24_1770_5b_0_5d_.repeat<8>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.tx_fifo_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:194.9-194.13|top.v:194.5-195.35
		// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$3170
		auto tmp_13 = memory_index((p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5065__o ? p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5153__q.curr : value<8>{0u}), 0, 256);
		CXXRTL_ASSERT(tmp_13.valid && "out of bounds write");
		if (tmp_13.valid) {
			// \full_case: 1
			// \src: top.v:194.9-194.13|top.v:194.5-195.35
			// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$3167
			memory_p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_memory.update(tmp_13.index, (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5065__o ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<24,15>().val() : value<10>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_195_24_1__EN_5b_9_3a_0_5d__24_52_5b_0_5d_.repeat<10>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.rx_fifo_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:8771.9-8771.13|top.v:8771.5-8772.35
		// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$2336
		auto tmp_14 = memory_index((p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n240__o ? p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n328__q.curr : value<8>{0u}), 0, 256);
		CXXRTL_ASSERT(tmp_14.valid && "out of bounds write");
		if (tmp_14.valid) {
			// \full_case: 1
			// \src: top.v:8771.9-8771.13|top.v:8771.5-8772.35
			// cell $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$2333
			memory_p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_memory.update(tmp_14.index, (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n240__o ? p_in__lost.concat(p_in__data).val() : value<9>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_8772_24_2266__EN_5b_8_3a_0_5d__24_2317_5b_0_5d_.repeat<9>().val(), 0);
		}
	}
	// memory \unity_link_inst.core_inst.response_ring_inst.memory write port 0
	if (posedge_p_clk) {
		// \full_case: 1
		// \src: top.v:3272.9-3272.14|top.v:3272.5-3273.37
		// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procmux$2859
		auto tmp_15 = memory_index((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2293__o ? p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3416__q.curr.slice<0>().val() : value<1>{0u}), 0, 2);
		CXXRTL_ASSERT(tmp_15.valid && "out of bounds write");
		if (tmp_15.valid) {
			// \full_case: 1
			// \src: top.v:3272.9-3272.14|top.v:3272.5-3273.37
			// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procmux$2856
			memory_p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_memory.update(tmp_15.index, (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2293__o ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3631__q.curr : value<8>{0u}), i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_24_memwr_24__5c_memory_24_top_2e_v_3a_3273_24_1293__EN_5b_7_3a_0_5d__24_1319_5b_0_5d_.repeat<8>().val(), 0);
		}
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$3185 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8731$2298 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8677$2271 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$add$top.v:8675$2270
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n328__q.next = (p_rst ? value<8>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n240__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n328__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n328__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$3184 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8733$2299 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8681$2273 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$add$top.v:8679$2272
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n329__q.next = (p_rst ? value<8>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n241__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n329__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n329__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$3183 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8735$2300 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8725$2295 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$add$top.v:8703$2284 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8719$2292 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$sub$top.v:8713$2289
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n281__o ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<1>{0x1u}) : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n289__o ? sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$3182 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8737$2301 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8727$2296 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8717$2291 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$and$top.v:8721$2293
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n281__o ? value<1>{0x1u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n271__o, p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n289__o) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$3181 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8739$2302 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8729$2297 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8707$2286 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$eq$top.v:8705$2285 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8723$2294
	if (posedge_p_clk) {
		p_in__ready.next = (p_rst ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n281__o ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_count.curr, value<8>{0xffu}) ? value<1>{0u} : p_in__ready.curr) : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n289__o ? value<1>{0x1u} : p_in__ready.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$3180 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8741$2303 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8695$2280
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n274__o ? p_in__lost.concat(p_in__data).val() : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$3179 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8743$2304 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8697$2281 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8693$2279
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n336__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n274__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n241__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n336__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procdff$3178 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$procmux$2338
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n337__data.next = (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n241__o ? i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_rx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_8769_24_2313__DATA : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n337__data.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_register_inst.$procdff$3187 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:8569$2263 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:8565$2261
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_character__valid.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_fifo__out__ready ? p_unity__link__inst_2e_core__inst_2e_fifo__out__valid.curr : p_unity__link__inst_2e_core__inst_2e_character__valid.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\rx_register_inst.$procdff$3186 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:8567$2262 $flatten\unity_link_inst.\core_inst.\rx_register_inst.$ternary$top.v:8563$2260 $flatten\unity_link_inst.\core_inst.\rx_fifo_inst.$ternary$top.v:8673$2269
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_character__in.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_fifo__out__ready ? (p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n336__q.curr ? p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_bypass.curr : p_unity__link__inst_2e_core__inst_2e_rx__fifo__inst_2e_n337__data.curr) : p_unity__link__inst_2e_core__inst_2e_character__in.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$procdff$3188 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8523$2254 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8521$2253 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8519$2252 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8121$2153 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8125$2154 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8129$2155 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8133$2156 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8137$2157 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8142$2158 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8008$2133 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8006$2132 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8516$2251 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8488$2245 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8492$2246 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8483$2244 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8477$2242 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$sub$top.v:8471$2240 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8467$2239 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$and$top.v:8479$2243 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8348$2216 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8497$2247 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8501$2248 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8505$2249 $flatten\unity_link_inst.\core_inst.\datalink_rx_inst.$ternary$top.v:8510$2250
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.next = (p_rst ? value<54>{0x28000000u,0x10u} : (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_advance ? (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<33>().val() ? (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n390__o ? value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<31>().val() ? value<4>{0x9u} : value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<30>().val() ? value<3>{0x7u} : value<3>{0u})).val())).concat(value<2>{0x3u}).val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<53,48>().concat(value<1>{0u}).val()).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n390__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n499__o)).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n390__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<45,38>().val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<7,0>().val())).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n390__o ? value<12>{0x40au} : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<37,34>().concat(value<1>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<32,26>()).val())).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n390__o ? value<10>{0u} : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n498__o.concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<17>()).val())).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<15,8>()).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n390__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<7,0>().val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<15,8>().val())).val() : (p_unity__link__inst_2e_core__inst_2e_character__valid.curr ? (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n540__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n762__o.slice<7,1>().val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<53,48>().concat(value<1>{0u}).val()).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n540__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n762__o.slice<0>().val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n867__o.slice<8>().val())).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n540__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<45,38>().val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n867__o.slice<7,0>().val())).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n540__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n759__o.slice<21,15>().val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<37,34>().concat(value<2>{0x1u}).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n530__o).val())).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n540__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n759__o.slice<14,0>().val() : (p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n770__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<30,26>().val() : (and_uu<1>((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n770__o ? value<1>{0u} : value<1>{0x1u}), p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n870__o) ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<30>().val()).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n870__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<29,26>().val() : sub_uu<4>(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<29,26>().val(), value<1>{0x1u}))).val()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n864__o.slice<25,16>()).val())).concat((p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n540__o ? p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<15,0>().val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n864__o.slice<15,0>().val())).val() : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<53,48>().concat(value<2>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<45,34>()).concat(value<1>{0u}).concat(p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr.slice<32,0>()).val())) : p_unity__link__inst_2e_core__inst_2e_datalink__rx__inst_2e_n920__q.curr));
	}
	// \src: top.v:5675.3-5676.28
	// cell $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procdff$3194
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.next = p_unity__link__inst_2e_core__inst_2e_memory__word.curr;
	}
	// cells $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procdff$3195 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5670$1761 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2639 $auto$opt_reduce.cc:131:opt_pmux$3376 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5469$1746 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:5466$1745 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5445$1738 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5414$1728 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5394$1722 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5375$1716 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5372$1715 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:5370$1714 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5327$1701 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2629 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4354$1420 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4352$1419 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:4363$1422 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$sub$top.v:4359$1421 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2619 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2609 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2599 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2589 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5419$1730 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5400$1724 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5366$1713 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$add$top.v:5363$1712 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$sub$top.v:5357$1710 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2579 $auto$opt_reduce.cc:131:opt_pmux$3364 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5448$1739 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5345$1707 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:5338$1705 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4369$1424 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ge$top.v:4367$1423 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2569 $auto$opt_reduce.cc:131:opt_pmux$3362 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5422$1731 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5403$1725 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5378$1717 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5330$1702 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2559 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2549 $auto$opt_reduce.cc:131:opt_pmux$3358 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5451$1740 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2539 $auto$opt_reduce.cc:131:opt_pmux$3356 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5455$1741 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2529 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:5410$1727 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:5424$1732 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$procmux$2519
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.next = (p_rst ? value<75>{0xd2000u,0x8000000u,0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3353 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<74>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2520__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3137__o.slice<4>().val() : value<1>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2523__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed, p_unity__link__inst_2e_core__inst_2e_access__done) ? p_unity__link__inst_2e_core__inst_2e_access__failure.curr : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<73,70>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3355 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<73,70>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2520__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3137__o.slice<3,0>().val() : value<4>{0u})))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2525__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3237__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<69,62>().concat(value<1>{0u}).val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<54,47>().concat(value<1>{0x1u}).val()) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2520__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2521__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2523__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2524__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2526__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2527__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<69,62>().concat(value<1>{0u}).val() : value<9>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2525__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3237__o ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<60,58>().val()) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2521__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2523__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2524__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2526__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2527__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<60,58>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2520__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3135__o.slice<4,2>().val() : value<3>{0u})))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2520__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3135__o.slice<1>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3353 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<57>().val() : value<1>{0u}))).concat((reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2524__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2525__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2526__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2527__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<56>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2523__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__done ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<56>().val())) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<56>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP ? value<1>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2521__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<55>().val() ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<56>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2520__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3135__o.slice<0>().val() : value<1>{0u})))))).concat((ge_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.curr, p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<117,110>().val()) ? value<1>{0x1u} : value<1>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2525__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3237__o ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<54,47>().val() : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3157__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2523__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<18>().val(), p_unity__link__inst_2e_core__inst_2e_access__granted) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3157__o : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<54,47>().val()) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2521__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2524__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2526__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2527__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<54,47>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2520__CMP ? value<8>{0u} : value<8>{0u}))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2523__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__done ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<46,31>().val() : sub_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<46,39>().val(), value<1>{0x1u}).concat((p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<38,31>().val() : add_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<38,31>().val(), value<1>{0x1u}))).val()) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<46,31>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3355 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<46,31>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2520__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3134__o.slice<30,15>().val() : value<16>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3353 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<30,21>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2520__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3134__o.slice<14,5>().val() : value<10>{0u}))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3353 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<20>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2520__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3134__o.slice<4>().val() : value<1>{0u}))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3353 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<19,16>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2520__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3134__o.slice<3,0>().val() : value<4>{0u}))).concat(not_u<1>(sub_uu<8>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<24,17>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<10,3>().val()).slice<7>().val())).concat((eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<24,17>().val(), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<10,3>().val()) ? value<1>{0x1u} : value<1>{0u})).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3353 ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<13,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2520__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3132__o.slice<13,3>().val() : value<11>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2527__CMP ? (or_uu<1>(p_unity__link__inst_2e_core__inst_2e_answer__taken, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<22>().val()) ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2525__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3237__o ? value<3>{0x7u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<2,0>().val()) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2524__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2526__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<2,0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2523__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__done ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_failed ? value<3>{0x7u} : (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<19,16>().val(), value<3>{0x7u}) ? value<3>{0u} : value<3>{0x7u}) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<2,0>().val())) : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2522__CMP ? value<3>{0x3u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2521__CMP ? (p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<55>().val() ? value<3>{0x3u} : p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__executor__inst_2e__24_procmux_24_2520__CMP ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3132__o.slice<2,0>().val() : value<3>{0u})))))))).val());
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$3204 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:3246$1306
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3416__q.next = (p_rst ? value<2>{0u} : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3383__o);
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$3203 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:3248$1307 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:3228$1297 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4176$1362
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.next = (p_rst ? value<2>{0u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2304__o, p_unity__link__inst_2e_core__inst_2e_answer__taken) ? p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3383__o : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_committed.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$3202 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:3250$1308 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:3232$1299 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1371$407 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$not$top.v:1369$406 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$add$top.v:3230$1298
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3418__q.next = (p_rst ? value<2>{0u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word, not_u<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<78>().val())) ? add_uu<2>(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3418__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3418__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$3201 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$ternary$top.v:3242$1304 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$sub$top.v:3236$1301 $flatten\unity_link_inst.\core_inst.\response_ring_inst.$sub$top.v:3234$1300
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_ring__room.next = (p_rst ? value<2>{0x2u} : sub_uu<2>(value<2>{0x2u}, sub_uu<2>(p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3416__q.curr, p_unity__link__inst_2e_core__inst_2e_response__ring__inst_2e_n3418__q.curr)));
	}
	// \src: top.v:3268.3-3270.37
	// cell $flatten\unity_link_inst.\core_inst.\response_ring_inst.$procdff$3199
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_response__ring__inst_2e__24_0_5c_n3423__data_5b_7_3a_0_5d_;
	}
	// cells $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procdff$3218 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2428$672 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2426$671 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3053 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1730$524 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1946$590 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2032$610 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2122$630 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2210$651 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3044 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3035 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3026 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1902$578 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3017 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3008 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1913$580 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2999 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2129$633 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$sub$top.v:2111$627 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1513$445 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4330$1413 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4328$1412 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4322$1410 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:4320$1409 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$eq$top.v:4326$1411 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2423$670 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2421$669 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2990 $auto$opt_reduce.cc:131:opt_pmux$3342 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2981 $auto$opt_reduce.cc:131:opt_pmux$3397 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2131$634 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2115$628 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1948$591 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1733$525 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2972 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2963 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2134$635 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2954 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1609$481 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3108 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3109_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3110_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3100 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3101_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3102_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3103_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3104_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3105_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$3106_CMP0 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1891$576 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:1883$574 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:1887$575 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1987$600 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:1979$598 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:1983$599 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2073$620 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:2065$618 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:2069$619 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2173$644 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$gt$top.v:2165$642 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$add$top.v:2169$643 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2945 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2936 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1735$526 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1937$586 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:1950$592 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2029$609 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$and$top.v:2036$612 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2124$631 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:2212$652 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$procmux$2927 $flatten\unity_link_inst.\core_inst.\frame_writer_inst.$ternary$top.v:1521$448
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.next = (p_rst ? value<93>{0u,0u,0u} : (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_advance ? (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3317 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<92,90>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2928__CMP ? (p_unity__link__inst_2e_core__inst_2e_answer__taken ? value<2>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<21>()).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<92,90>().val()) : value<3>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2928__CMP ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2929__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4073__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4123__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4123__o : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2931__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4114__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o) ? value<1>{0x1u} : value<1>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2932__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4106__o, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o) ? value<1>{0x1u} : value<1>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2933__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4583__o ? value<1>{0x1u} : value<1>{0u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2934__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o ? value<1>{0x1u} : value<1>{0u}) : value<1>{0u})))))))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3317 ? value<1>{0x1u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2928__CMP ? value<1>{0u} : value<1>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2928__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<87,80>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2929__CMP ? value<2>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<8>()).concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<7>().val() ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3861__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3857__o).val(), value<1>{0x1u}) ? value<5>{0x18u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3861__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3857__o).val(), value<2>{0x2u}) ? value<5>{0xeu} : value<5>{0x10u})) : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3947__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3938__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3929__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3920__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3911__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3890__o).val(), value<1>{0x1u}) ? value<5>{0x12u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3947__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3938__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3929__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3920__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3911__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3890__o).val(), value<2>{0x2u}) ? value<5>{0x17u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3947__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3938__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3929__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3920__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3911__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3890__o).val(), value<3>{0x4u}) ? value<5>{0x9u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3947__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3938__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3929__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3920__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3911__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3890__o).val(), value<4>{0x8u}) ? value<5>{0x8u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3947__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3938__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3929__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3920__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3911__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3890__o).val(), value<5>{0x10u}) ? value<5>{0x11u} : (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3947__o.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3938__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3929__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3920__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3911__o).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3890__o).val(), value<6>{0x20u}) ? value<5>{0xbu} : value<5>{0x7u})))))))).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP ? value<2>{0x1u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<8>()).concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4071__o).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2931__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4322__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4322__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4322__o).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2932__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4425__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4425__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4425__o).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2933__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4518__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4518__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4518__o).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2934__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4622__o, value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4622__o)).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4622__o).val()) : value<8>{0u})))))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2933__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<79>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3347 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<79>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2928__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3842__o.slice<1>().val() : value<1>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3317 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<78>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2928__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3842__o.slice<0>().val() : value<1>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2934__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4362__o : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2933__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o ? value<3>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<79>().val() ? value<3>{0x7u} : value<3>{0x1u})).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4362__o) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2931__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2932__CMP).val()) ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o ? value<6>{0x1u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4362__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4122__o : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2929__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4073__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<77,72>().val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4122__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2928__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<77,72>().val() : value<6>{0u}))))))).concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_load__word ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<78>().val() ? value<32>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_response__word.curr.concat(value<24>{0u}).val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3341 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<67,40>().concat(value<4>{0u}).val() : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2928__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2929__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<71,40>().val() : value<32>{0u})))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2933__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o ? sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<39,31>().val(), value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<39,31>().val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3347 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<39,31>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2928__CMP ? (p_unity__link__inst_2e_core__inst_2e_answer__taken ? value<1>{0u}.concat((and_uu<1>(logic_not<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<19,18>().val()), and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<74>().val()), p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2376__o)) ? p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<117,110>().val() : value<8>{0u})).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<39,31>().val()) : value<9>{0u})))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2928__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3835__o.slice<21,14>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3315 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<30,23>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3341 ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3751__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<26,23>().concat(value<4>{0u}).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<30,23>().val()) : value<8>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3317 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<22,19>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2928__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3835__o.slice<13,10>().val() : value<4>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2928__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3835__o.slice<9,2>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3315 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<18,11>().val() : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3341 ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3728__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<14,11>().concat(value<4>{0u}).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<18,11>().val()) : value<8>{0u})))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3317 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<10,9>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2928__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3835__o.slice<1,0>().val() : value<2>{0u}))).concat((i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3317 ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<8,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2928__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3832__o.slice<8,3>().val() : value<6>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2928__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3832__o.slice<2,0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2929__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4073__o ? value<3>{0x2u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4121__o) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2930__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4121__o : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2931__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4112__o : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2932__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4110__o : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2933__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4583__o ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_frame__writer__inst_2e__24_procmux_24_2934__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n3712__o ? value<3>{0u} : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<2,0>().val()) : value<3>{0u})))))))).val() : p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3217 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3117$1273 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2892 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2953$1231 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2977$1243 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2967$1238
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3623__q.next = (p_rst ? value<2>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2863__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? value<2>{0x1u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3623__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2864__CMP ? (p_unity__link__inst_2e_bus__done ? value<2>{0x2u} : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3520__o ? value<2>{0x2u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3623__q.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP ? value<2>{0u} : value<2>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3216 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3119$1274 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2887 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2933$1221
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.next = (p_rst ? value<1>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3329 ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2863__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr) : value<1>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3215 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3121$1275 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2882 $auto$opt_reduce.cc:131:opt_pmux$3326 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2985$1247 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:2991$1250
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3496__o.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3541__o) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3496__o.curr) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2863__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2864__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3496__o.curr : value<1>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3214 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3123$1276 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2877 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2935$1222 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$and$top.v:4148$1350 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:4146$1349 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$not$top.v:4144$1348 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2993$1251 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2987$1248
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3626__q.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2863__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? and_uu<1>(not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_last__word), not_u<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_is__queue)) : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3626__q.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2864__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3626__q.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3541__o ? (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_for__sample.curr ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3626__q.curr : value<1>{0u}) : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3626__q.curr) : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3212 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3127$1278 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2867 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2979$1244 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2969$1239
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3628__q.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2863__CMP ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2864__CMP ? (p_unity__link__inst_2e_bus__done ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3628__q.curr : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3520__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3628__q.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3628__q.curr : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3211 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3129$1279 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2862 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$sub$top.v:2957$1233
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3629__q.next = (p_rst ? value<11>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2863__CMP ? value<11>{0x3ffu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2864__CMP ? sub_uu<11>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3629__q.curr, value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3629__q.curr : value<11>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3210 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3105$1267 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2922 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2971$1240 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2959$1234 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2963$1236
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_access__failure.next = (p_rst ? value<4>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2864__CMP ? (p_unity__link__inst_2e_bus__done ? value<1>{0u}.concat((p_wb__err ? value<3>{0x4u} : value<3>{0u})).val() : value<1>{0u}.concat((p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3520__o ? value<3>{0x5u} : value<3>{0u})).val()) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3337 ? p_unity__link__inst_2e_core__inst_2e_access__failure.curr : value<4>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3209 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3107$1268 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2917 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2973$1241
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3631__q.next = (p_rst ? value<8>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2864__CMP ? (p_unity__link__inst_2e_bus__done ? p_wb__dat__i : p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3631__q.curr) : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3337 ? p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3631__q.curr : value<8>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3208 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3109$1269 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2912 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2945$1227 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2975$1242 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2965$1237
	if (posedge_p_clk) {
		p_wb__stb.next = (p_rst ? value<1>{0u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2863__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? value<1>{0x1u} : p_wb__stb.curr) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2864__CMP ? (p_unity__link__inst_2e_bus__done ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3520__o ? value<1>{0u} : p_wb__stb.curr)) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2865__CMP ? p_wb__stb.curr : value<1>{0u}))));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3207 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3111$1270 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2907 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2947$1228 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:2941$1225
	if (posedge_p_clk) {
		p_wb__we.next = (p_rst ? value<1>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3329 ? p_wb__we.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2863__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? and_uu<1>(p_unity__link__inst_2e_core__inst_2e_access__granted, p_unity__link__inst_2e_core__inst_2e_access__exclusive) : p_wb__we.curr) : value<1>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3206 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3113$1271 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2902 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2949$1229
	if (posedge_p_clk) {
		p_wb__adr.next = (p_rst ? value<8>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3329 ? p_wb__adr.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2863__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n3341__q.curr.slice<38,31>().val() : p_wb__adr.curr) : value<8>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procdff$3205 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:3115$1272 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$procmux$2897 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$ternary$top.v:2951$1230 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4154$1352 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$ternary$top.v:4086$1327 $flatten\unity_link_inst.\core_inst.\request_executor_inst.$or$top.v:4084$1326
	if (posedge_p_clk) {
		p_wb__dat__o.next = (p_rst ? value<8>{0u} : (i_auto_24_opt__reduce_2e_cc_3a_137_3a_opt__pmux_24_3329 ? p_wb__dat__o.curr : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_bus__master__inst_2e__24_procmux_24_2863__CMP ? (p_unity__link__inst_2e_core__inst_2e_access__granted ? ((or_uu<1>(p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2192__o, p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_n2195__o) ? value<1>{0x1u} : value<1>{0u}) ? p_unity__link__inst_2e_core__inst_2e_request__executor__inst_2e_memory__kept.curr : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.curr.slice<80,73>().val()) : p_wb__dat__o.curr) : value<8>{0u})));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$3223 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procmux$3172
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5162__data.next = (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5066__o ? i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_tx__fifo__inst_2e__24_memrd_24__5c_memory_24_top_2e_v_3a_192_24_48__DATA : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5162__data.curr);
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$3224 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:166$39 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:120$16 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:116$14
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5161__q.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5099__o ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5066__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5161__q.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$3225 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:164$38 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:118$15
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.next = (p_rst ? value<10>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5099__o ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<24,15>().val() : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$3226 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:162$37 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:152$32 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:130$21 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$eq$top.v:128$20 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:146$29
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_out__ready.next = (p_rst ? value<1>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5106__o ? (eq_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<8>{0xffu}) ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_out__ready.curr) : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5114__o ? value<1>{0x1u} : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_out__ready.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$3227 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:160$36 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:150$31 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:140$26 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$and$top.v:144$28
	if (posedge_p_clk) {
		p_out__valid.next = (p_rst ? value<1>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5106__o ? value<1>{0x1u} : (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5096__o, p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5114__o) ? value<1>{0u} : p_out__valid.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$3228 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:158$35 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:148$30 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$add$top.v:126$19 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:142$27 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$sub$top.v:136$24
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.next = (p_rst ? value<9>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5106__o ? add_uu<9>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<1>{0x1u}) : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5114__o ? sub_uu<9>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_count.curr)));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$3229 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:156$34 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:104$8 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$add$top.v:102$7
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5154__q.next = (p_rst ? value<8>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5066__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5154__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5154__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$procdff$3230 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:154$33 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:100$6 $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$add$top.v:98$5
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5153__q.next = (p_rst ? value<8>{0u} : (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5065__o ? add_uu<8>(p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5153__q.curr, value<1>{0x1u}) : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5153__q.curr));
	}
	// cells $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$procdff$3189 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7606$2123 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7593$2120 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7596$2121 $flatten\unity_link_inst.\core_inst.\request_decoder_inst.$ternary$top.v:7599$2122
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2133__q.next = (p_rst ? value<118>{0x10u,0u,0u,0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2074__o.slice<117,103>().concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2076__o ? value<2>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2074__o.slice<102,101>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2074__o.slice<100,17>()).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2076__o ? value<1>{0u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2074__o.slice<16>().val())).concat(p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2074__o.slice<15,12>()).concat((p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2076__o ? value<12>{0x10u} : p_unity__link__inst_2e_core__inst_2e_request__decoder__inst_2e_n2074__o.slice<11,0>().val())).val());
	}
	// \src: top.v:5690.3-5692.40
	// cell $flatten\unity_link_inst.\core_inst.\request_memory_inst.$procdff$3193
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_memory__word.next = i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_request__memory__inst_2e__24_0_5c_n2155__data_5b_7_3a_0_5d_;
	}
	// \src: top.v:96.20-96.51
	// cell $flatten\unity_link_inst.\core_inst.\tx_fifo_inst.$ternary$top.v:96$4
	p_out__data = (p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5161__q.curr ? p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_bypass.curr.slice<7,0>().val() : p_unity__link__inst_2e_core__inst_2e_tx__fifo__inst_2e_n5162__data.curr.slice<7,0>().val());
	// cells $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procdff$3219 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:772$132 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:770$131 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$3154 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:647$113 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$and$top.v:641$111 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:643$112 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:676$120 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$3147 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$sub$top.v:669$118 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$3140 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:633$108 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:629$107 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$auto$opt_expr.cc:702:replace_const_cells$3297 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$3133 $auto$opt_reduce.cc:131:opt_pmux$3344 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$3126 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:541$88 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:637$109 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:661$117 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$gt$top.v:653$115 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$add$top.v:657$116 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$3119 $auto$opt_reduce.cc:131:opt_pmux$3324 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$procmux$3112 $auto$opt_reduce.cc:131:opt_pmux$3399 $auto$opt_reduce.cc:131:opt_pmux$3318 $flatten\unity_link_inst.\core_inst.\datalink_tx_inst.$ternary$top.v:639$110
	if (posedge_p_clk) {
		p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.next = (p_rst ? value<26>{0x1u} : (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_advance ? (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3113__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3114__CMP).val()) ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<88>().val() ? value<1>{0x1u} : value<1>{0u}) : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3115__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3116__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3117__CMP).val()) ? value<1>{0x1u} : value<1>{0u})).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3117__CMP ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<14,13>().val() : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3113__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3114__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3115__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3116__CMP).val()) ? value<2>{0u} : value<2>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3113__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<88>().val() ? value<1>{0u}.concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4814__o_5b_6_3a_0_5d_).val() : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<22,15>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3114__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<88>().val() ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<87,80>().val() : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<22,15>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3115__CMP ? (gt_uu<1>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<12,9>().val(), value<4>{0x9u}) ? value<1>{0u}.concat(add_uu<7>(value<6>{0x37u}, p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<12,9>().val())).val() : value<4>{0x3u}.concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<12,9>()).val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3116__CMP ? value<8>{0xdu} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3117__CMP ? value<8>{0xau} : value<8>{0u})))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3114__CMP ? p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<92,91>().val() : (reduce_or<1>(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3113__CMP.concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3115__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3116__CMP).concat(i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3117__CMP).val()) ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<14,13>().val() : value<2>{0u}))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3113__CMP ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4896__o.slice<12,5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3114__CMP ? (p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<88>().val() ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4937__o_5b_2_3a_0_5d_.slice<2>().concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4944__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4951__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4958__o_5b_2_3a_0_5d_.slice<2>()).concat(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4965__o_5b_2_3a_0_5d_.slice<2>()).concat((p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4930__o_5b_2_3a_0_5d_.slice<2>().val() ? not_u<3>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4965__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val()) : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4965__o_5b_2_3a_0_5d_.slice<1,0>().concat(value<1>{0u}).val())).val() : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<12,5>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3115__CMP ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<8,5>().concat(value<4>{0u}).val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3116__CMP ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<12,5>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3117__CMP ? value<8>{0u} : value<8>{0u})))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3113__CMP ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4896__o.slice<4,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3114__CMP ? value<2>{0x2u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3115__CMP ? sub_uu<2>(p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<4,3>().val(), value<1>{0x1u}) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3116__CMP ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<4,3>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3117__CMP ? value<2>{0u} : value<2>{0u})))))).concat((i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3113__CMP ? p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4896__o.slice<2,0>().val() : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3114__CMP ? (and_uu<1>(p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<89>().val(), p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<88>().val()) ? value<2>{0x1u}.concat((p_unity__link__inst_2e_core__inst_2e_frame__writer__inst_2e_n4744__q.curr.slice<90>().val() ? value<1>{0x1u} : value<1>{0u})).val() : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3115__CMP ? (p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n4810__o ? value<3>{0x4u} : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr.slice<2,0>().val()) : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3116__CMP ? value<3>{0x4u} : (i_flatten_5c_unity__link__inst_2e__5c_core__inst_2e__5c_datalink__tx__inst_2e__24_procmux_24_3117__CMP ? value<3>{0x1u} : value<3>{0u})))))).val() : p_unity__link__inst_2e_core__inst_2e_datalink__tx__inst_2e_n5058__q.curr));
	}
	// cells $flatten\unity_link_inst.\wishbone_master_inst.$or$top.v:8856$2324 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$and$top.v:2925$1217 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$not$top.v:2923$1216 $flatten\unity_link_inst.\core_inst.\bus_master_inst.$or$top.v:2921$1215
	p_wb__cyc = or_uu<1>(p_wb__stb.curr, and_uu<1>(or_uu<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3496__o.curr, p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3626__q.curr), not_u<1>(p_unity__link__inst_2e_core__inst_2e_bus__master__inst_2e_n3628__q.curr)));
	// connection
	p_out__flush = value<1>{0u};
	// connection
	p_wb__sel = value<1>{0x1u};
	return converged;
}

} // namespace cxxrtl_design

